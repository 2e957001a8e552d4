// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// 页面的全部中文文字。数字与算例中一样使用小数点。

import { zh as replayWords } from "../../../viewer/src/text/zh.js";

const plain = (key) => key.replaceAll(/[_-]/g, " ");
const seconds = (number) => `${number < 10 ? number.toPrecision(2) : Math.round(number)} s`;

/// 类型、求解器以及算例中其他词的名称。
const words = {
  auto: "由程序选择", event: "事件驱动求解器", soft: "软球求解器（接触力）",
  still: "静止", vibration: "振动罐", planetary: "行星式球磨机", tumbling: "滚筒球磨机",
  "arc-shaker": "振动磨（圆弧摆动）", "figure-eight": "振动磨（8 字形）",
  circular: "圆周运动", capsule: "胶囊形（两端半球）", cylinder: "圆柱形",
  "rounded-cylinder": "圆角圆柱形", sphere: "球形", box: "长方体", "lifter-cylinder": "带提升条的圆筒",
  none: "无", equal: "全部相同",
};

const exampleCases = {
  "vibrating-vial": { name: "振动罐（Chen 等，2016）",
    hint: "一个磨球在振动的胶囊形罐中弹跳。试试 14 Hz：功率是否按频率的三次方增长？" },
  "mixer-mill": { name: "Retsch MM 400",
    hint: "两个磨球在沿圆弧摆动的罐中。改成一个磨球，比较两者的能谱。" },
  "planetary-mill": { name: "Fritsch Pulverisette 7（行星式）",
    hint: "行星式球磨机中的七个磨球。试试把转速从 200 扫描到 800 rpm。" },
  "tumbling-drum": { name: "滚筒球磨机",
    hint: "磨球沿筒壁上升后落下。试试 100 % 临界转速，看磨球如何贴在筒壁上。" },
  "shaker-mill": { name: "SPEX 8000M",
    hint: "大小磨球沿 8 字形运动。去掉小球试试：哪些碰撞消失了？" },
  quartz: { name: "石英能磨多细",
    hint: "从碰撞到研磨一小时后的粒度。试试 300 rpm，并查看粉末的结果。" },
};

/// 课程，顺序与 learn/lessons.js 相同，正确答案写在那里。
const lessons = [
  { title: "一次碰撞值多少？",
    intro: "球磨罐每秒振动十次，一个磨球在两端之间弹跳。每次碰撞都把磨球的一部分能量变成热，或者用来击碎颗粒。" +
      "功率就是每秒内这些能量的总和。",
    task: "用三个频率计算，观察功率和碰撞次数。", varied: "频率",
    question: "频率从 10 Hz 加倍到 20 Hz，振幅不变。功率会怎样？",
    answers: [
      ["变为两倍。", "每秒的碰撞次数变为两倍。但每次碰撞也更强：罐壁的速度也加倍了。"],
      ["变为四倍。", "单次碰撞的能量变为四倍：速度加倍，能量与速度的平方成正比。但每秒的碰撞次数也加倍了。"],
      ["变为八倍。", "碰撞次数加倍，每次的能量变为四倍：2 × 4 = 8，即 2 的三次方。" +
        "罐壁的最大速度是 2π × 频率 × 振幅，能量与速度的平方成正比。"],
      ["不变：磨球没有变。", "磨球没有变，但驱动它的罐壁更快了。"]],
    conclusion: "从 10 Hz 到 20 Hz：碰撞次数为 2.1 倍，单次能量为 3.9 倍，功率为 8 倍。" },
  { title: "为什么转速更高，研磨反而更弱？",
    intro: "六个磨球在滚筒中滚动。提升条把它们带上去，然后它们落下。达到临界转速时，筒壁处的离心力等于重力。",
    task: "分别在临界转速以下和以上计算，在动画中观察磨球。",
    varied: "转速（占临界转速）",
    question: "滚筒转速从临界转速的 75 % 提高到 125 %。碰撞会怎样？",
    answers: [
      ["变强：滚筒更快。", "起作用的是磨球相对于被撞物体的速度。随筒壁一起转动的磨球并不撞击筒壁。"],
      ["变弱：磨球随筒壁一起转。", "超过临界转速后，即使在最高点，离心力也大于重力：磨球不再落下，只剩下在提升条之间的轻微碰撞。"],
      ["不变：下落高度相同。", "磨球在重力能把它拉离筒壁的地方落下。超过临界转速后，这样的地方不存在。"],
      ["完全没有碰撞。", "一个从不打滑的磨球确实不会撞到任何东西。但这里磨球仍在提升条之间碰撞，只是很弱。"]],
    conclusion: "在 125 % 时，单次碰撞的能量约为 75 % 时的三分之一，功率也约为三分之一。因此滚筒磨机一般在临界转速的 65 % 到 80 % 运行。" },
  { title: "少量大球还是大量小球？",
    intro: "行星式球磨机的罐中装有 96 g 钢球：七个 15 mm 的磨球，或者质量几乎相同的 24 个 10 mm 的磨球。",
    task: "两种都计算，比较能谱：碰撞有多少次，有多强？", varied: "磨球",
    question: "用 24 个小球代替七个大球。碰撞会怎样？",
    answers: [
      ["次数更少，每次更强。", "正好相反：小球更轻，也更常与其他球相碰。"],
      ["次数更多，每次更弱。", "10 mm 磨球的质量是 15 mm 磨球的 0.3 倍，球多则相碰更频繁：同样的功率分给了更多次碰撞。"],
      ["次数更多，每次一样强：转速相同。", "速度相近，但碰撞能量是 ½ m v²，而磨球质量 m 只有原来的 0.3 倍。"],
      ["和原来一样：总质量相同。", "磨球总质量大致决定吸收多少功率，磨球数量决定功率分给多少次碰撞。"]],
    conclusion: "碰撞次数约为六倍，每次的能量约为七分之一。粗而坚硬的颗粒需要强碰撞，用较大的球；细粉需要大量碰撞，用较小的球。" },
  { title: "磨球越多，作用越大吗？",
    intro: "这个罐内长 48 mm，磨球直径 8 mm。磨球越多，碰撞越多，但也占去了其他磨球飞行的空间。",
    task: "分别用一个、两个、四个和六个磨球计算。", varied: "磨球数",
    question: "六个磨球代替一个：六个磨球的总功率有多大？",
    answers: [
      ["是一个磨球的六倍。", "那要求每个磨球都像单独一个那样自由飞行。但它们会先彼此相碰，而且速度较低。"],
      ["比一个大，但不到六倍。", "到四个磨球为止确实如此。六个磨球错开叠起来长 43 mm：剩下的空间太小。"],
      ["比一个磨球小。", "六个磨球几乎从一端填到另一端。它们随罐一起运动，彼此之间以及与罐壁只以很低的速度接触。"],
      ["一样：由罐决定。", "罐决定运动，但磨球吸收多少能量取决于它们碰撞时的速度。"]],
    conclusion: "功率在中等填充率时最大，这里大约是四个磨球。磨球越多，单次碰撞的能量越低。" },
  { title: "哪些数字可信？",
    intro: "± 后面的数字是 95 % 置信区间：本次计算的平均值与无限长计算的平均值可能相差这么多。这里比较两次短计算。",
    task: "在 10 Hz 和 11 Hz 下各计算 2 s，查看功率的区间，再看更长的计算。",
    varied: "频率、时间、恢复系数 e",
    question: "10 Hz 计算 2 s 得 40 ± 7 mW，11 Hz 计算 2 s 得 51 ± 15 mW。这两次计算说明什么？",
    answers: [
      ["11 Hz 的功率更大：51 大于 40。", "也许是。但两个区间有重叠：在这么短的计算中，这样的差别也可能出于偶然。"],
      ["功率相同：区间有重叠。", "重叠不能证明相等，只说明这两次计算无法判断。"],
      ["还不够；更长的计算可以判断。", "模拟时间变为四倍，区间缩小一半。计算 200 s 后，两个区间不再重叠。"],
      ["什么也说明不了：模拟不可信。", "区间说明偶然性有多大，在这个范围内可以相信。即使有些值从未测量过，同一台磨机的两种设定也可以比较。"]],
    conclusion: "长计算能区分两个频率。但区间只包含偶然性：恢复系数 0.9 是假定的，改为 0.8 时碰撞次数只有三分之一，远在区间之外。" +
      "不过两种情况下 11 Hz 的功率都是 10 Hz 的 1.3 倍：设定之间的差别比单个数字更可信。" },
];

const sections = { mill: "球磨机", jar: "球磨罐", balls: "磨球", powder: "粉末", contact: "接触",
  run: "计算", drive: "磨机电机", flow: "通过罐的流动" };
const counters = { collisions: "已计算碰撞", simulated: "已模拟时间", power: "耗散功率", rate: "阈值以上碰撞" };
const severities = { invalid: "超出有效范围：", warning: "警告：", note: "提示：" };
const verdicts = { apart: "不同", overlap: "可能相等", unknown: "无区间" };

const quantityNames = {
  dissipated_power: "耗散功率", collision_rate: "碰撞频率", drawn_power: "吸收功率",
  collision_rate_above_threshold: "阈值以上碰撞频率", collision_rate_in_flight: "飞行中碰撞频率",
  energy_normal_mean: "平均法向碰撞能量",
  energy_normal_mean_above_threshold: "阈值以上平均法向碰撞能量",
  energy_lost_mean: "平均能量损失", impact_speed_normal_mean: "平均法向碰撞速度",
  impact_angle_mean: "平均碰撞角", impact_efficiency: "碰撞效率",
  contact_time_share: "接触时间占比", impacts_per_ball: "每球碰撞频率",
  impacts_per_ball_above_threshold: "阈值以上每球碰撞频率", ball_count: "磨球数",
  balls_mass: "磨球质量", simulated_time: "模拟时间", settling_time: "稳定时间", replicates: "重复次数",
  specific_energy_dose_rate: "单位粉末质量的剂量率", specific_energy_dose: "剂量（单位粉末质量的能量）",
  specific_energy_dose_per_hour: "每小时剂量", time_to_dose: "达到剂量的时间", milling_time: "研磨时间",
  specific_impact_power: "单位粉末质量的碰撞功率", d10: "D10", d50: "D50", d90: "D90", conversion: "转化率",
};
const groupNames = { Collisions: "碰撞", "Power and contacts": "功率与接触", "Power of the mill": "磨机功率",
  "Motion of the charge": "装料的运动", "Numerical accuracy": "数值精度", Fineness: "细度",
  "Energy per mass of powder": "单位粉末质量的能量", Dose: "剂量", Wear: "磨损", Temperatures: "温度",
  Drive: "驱动", Flow: "流动", Mixing: "混合", "Powder captured by collisions": "碰撞捕获的粉末" };
const keyNames = {
  frequency: "频率", amplitude: "振幅", speed: "转速", ratio: "转速比", tilt: "倾角",
  jar_axis: "罐的轴线", jars_carried: "磨机上的罐数", orbit_radius: "公转半径", arm: "臂长",
  swing: "单侧摆幅", ratio_convention: "转速比的定义", radius: "半径",
  diameter: "直径", height: "高度", volume: "容积", length: "长度", width: "宽度", depth: "深度",
  fillet: "圆角半径", wall: "壁厚", lifters: "提升条数", lifter_height: "提升条高度",
  lifter_width: "提升条宽度", count: "磨球数", filling: "填充率（实体）", bulk_filling: "填充率（堆积）",
  mass: "质量", density: "密度", material: "材料", shape: "形状", distribution: "分布", size: "粒度",
  spread: "分布宽度", ball_to_powder: "球料比", void_filling: "空隙填充率",
  law: "接触模型", restitution: "恢复系数", tangential_restitution: "切向恢复系数", friction: "摩擦系数",
  rolling_friction: "滚动摩擦", lasting: "持续接触", contact_time: "接触时间", softening: "软化系数",
  youngs_modulus: "杨氏模量", poisson_ratio: "泊松比", hardness: "硬度",
  engine: "求解器", time: "模拟时间", settle: "稳定时间（不计入）", replicates: "重复次数",
  start: "初始状态", time_step: "时间步长", sensitivity: "敏感性", motor: "电机", inertia: "转动惯量",
  torque: "转矩",
};

const estimate = {
  mill: { label: "球磨机", remedy: "请从列表中选择" },
  jar: { label: "球磨罐", remedy: "请从列表中选择" },
  material: { label: "磨球和罐的材料" },
  balls: { label: "磨球", hint: "或 50 g x 3 mm",
    remedy: "请写数量和直径，如 2x10mm，或 50 g x 3 mm，或 30 % x 5 mm（占罐容积）；两组之间用逗号" },
  drive: { label: "频率" },
  powder: { label: "粉末", hint: "或球料比，如 10:1",
    remedy: "请写质量，如 200 mg，或球料质量比，如 10:1" },
  time: { label: "研磨时间", remedy: "请填写粉末，或不填时间" },
};
const sentence = (words) => (words === "" ? "" : `${words[0].toUpperCase()}${words.slice(1).replace(/[.。]$/, "")}` +
  (/[\u4e00-\u9fff]/.test(words) ? "。" : "."));

function status(run) {
  if (!run) return "就绪。";
  const sum = seconds(run.sum("simulated") || 0);
  const of = run.replicates.length === 1 ? "" : `（${run.replicates.length} 次重复）`;
  if (run.status === "done" && run.endedEarly()) return `提前结束：已模拟 ${sum}${of}；原因见结果的提示。`;
  if (run.status === "done") return `完成：已模拟 ${sum}${of}，用时 ${seconds(run.seconds)}。`;
  if (run.status === "stopped") return `已停止：已模拟 ${sum}，结果包含已计算的部分。`;
  if (run.status === "failed") return `计算失败：${run.message}`;
  const percent = `${Math.floor(100 * run.share())} %`;
  if (run.status === "paused") return `已暂停于 ${percent}。`;
  if (run.status === "stopping") return "正在停止……";
  if (run.status === "merging") return "正在合并各次重复……";
  return `正在计算${of}：${percent}，已模拟 ${sum}。`;
}

export const text = {
  language: "zh",
  shortName: "中文",
  languageName: "中文（简体）",
  languageChoice: "语言",
  quantityNames,
  groupNames,
  keyNames,
  numbers: { to: "至", infinite: "无穷大" },
  name: "Mahlwerk",
  tagline: "球磨机内部发生了什么",
  skip: "跳到结果",
  loading: "正在加载模拟器……",
  loadFailed: (why) => `无法加载模拟器：${why}`,
  version: (version) => `Mahlwerk ${version}`,
  englishParts: "程序的消息、含义说明和报告为英文。",
  footer: "所有计算都在本设备上进行，不发送任何数据。自由软件，Apache 许可证 2.0。",
  licences: "许可证",
  toDark: "深色",
  toLight: "浅色",
  themeAbout: "切换深色和浅色",

  estimate: "估算",
  estimateHeading: "估算一台磨机",
  estimateAbout: "生成算例，显示在下方并计算。所作的假定列在“关于这些数字”中；这些值的影响范围可用命令行 mahlwerk estimate 计算。",
  estimateWord: (word) => estimate[word].label,
  estimateHint: (word) => estimate[word].hint ?? "",
  estimateDrive: (key) => (key === "speed" ? "转速" : "频率"),
  estimateRange: ({ least, most, fixed }) => fixed ? `留空：${fixed}，该磨机的值`
    : !most ? "" : least ? `${least} 至 ${most}` : `最高 ${most}`,
  estimateFault: (kind, word, fault) => kind === "missing" ? "请填写此项。"
    : `${sentence(fault.text)} ${sentence(kind === "written" ? estimate[word].remedy : fault.remedy)}`.trim(),

  exampleCases,
  example: "从示例开始",
  ownCase: "自己的算例",
  caseHeading: "算例",
  form: "表单",
  caseText: "算例文本（TOML）",
  caseTab: "文本",
  resultHeading: "结果",
  runHeading: "计算",
  regions: "显示的部分",
  replay: "运动罐中的磨球",
  replayWords,

  learn: "学习",
  learnAbout: "五节带问题的课程",
  learnIntro: "每节课提出一个问题。先猜，再让页面算出答案。",
  learnClose: "关闭课程",
  lessons,
  lessonName: (number, title) => `第 ${number} 课：${title}`,
  lessonDone: "已答对",
  lessonTry: "计算",
  lessonQuestion: "问题",
  lessonRight: "正确。",
  lessonWrong: "不完全对。",
  lessonCheck: "自己验证",
  lessonCheckAbout: "计算本课的各个算例，并给出 95 % 置信区间。",
  lessonStatus: (at, count) => `正在计算第 ${at} 个算例，共 ${count} 个……`,
  lessonResult: "计算结果说明",
  lessonNext: "下一课",
  section: (name) => sections[name] ?? plain(name),
  ballSet: (number) => `磨球，第 ${number} 组`,
  part: (name) => `部件：${name}`,
  addBalls: "添加一组磨球",
  remove: "删除",
  word: (word) => words[word] ?? plain(word),
  kind: (kind) => words[kind] ?? plain(kind),
  model: (where) => (where === "mill" ? "球磨机" : "球磨罐"),
  byItsNumbers: "按参数",
  fromCatalogue: "从目录选择",
  containsUnverified: "含未核实的值",
  unitOf: (label) => `单位：${label}`,
  sliderOf: (label) => `滑块：${label}`,
  automatic: "自动",
  lineNumber: (line) => `第 ${line} 行`,
  remedy: (remedy) => `解决办法：${remedy}`,
  faultsFirst: "算例有错误，请先改正。",
  faultCount: (count) => (count === 1 ? "算例有一个错误：" : `算例有 ${count} 个错误。第一个：`),
  showFaults: "显示",

  run: "运行",
  pause: "暂停",
  resume: "继续",
  stop: "停止",
  progress: "计算进度",
  status,
  changed: "得到此结果后算例已更改。",
  sweeping: "正在计算扫描。",
  counter: (key) => counters[key],

  share: "分享",
  shareAbout: "复制包含整个算例的链接",
  shared: "链接已复制。它包含整个算例，没有发送任何数据。",
  sharedAddress: "本页地址现在包含整个算例，请从地址栏复制。",
  badLink: "此链接中没有可读的算例，改为显示第一个示例。",
  badLinkLater: "地址中没有可读的算例，保留当前算例。",
  keptCase: "这是您上次离开时的算例。点击“运行”开始计算。",
  leaveChanges: "离开对算例的更改吗？浏览器的“后退”可以恢复。",
  fromLink: "此算例来自链接。点击“运行”开始计算。",

  spectrum: "碰撞能谱",
  spectrumOf: "能谱类型",
  rate: "频率",
  power: "功率",
  spectrumRateAbout: "每秒碰撞次数随碰撞能量的分布",
  spectrumPowerAbout: "碰撞功率随碰撞能量的分布",
  spectrumAbout: (peak) => `最高处在 ${peak} 附近。`,
  impactEnergy: "法向碰撞能量",
  rateAxis: "每倍频程的频率，1/s",
  powerPerOctave: "每倍频程的功率",
  powerAxis: "功率",
  thisRun: "本次计算",
  powerOverTime: "功率随时间的变化",
  timeAxis: "模拟时间，s",
  dissipated: "耗散",
  meanSoFar: "目前平均值",

  details: "结果详情",
  quantities: "物理量",
  quantityColumns: ["物理量", "值 ± 95 % 区间", "含义"],
  noMillingTime: "未给出研磨时间",
  preliminary: "初步结果：正在计算，区间还会缩小。",
  noResult: "还没有结果：请点击“运行”。",
  noCurve: "还没有可画的内容。",

  comparison: "比较",
  keepAsA: "将此结果保留为 A",
  forgetA: "放弃 A",
  restoreA: "回到 A 的算例",
  compareHint: "将一个结果保留为 A，更改算例后再运行：两者会并排显示在这里。",
  compareRunB: (title) => `A 是“${title}”。现在更改算例并运行：下一个结果为 B。`,
  compareAbout: (a, b) => `A 是“${a}”，B 是“${b}”。“不同”表示 95 % 区间不重叠。`,
  differences: (list) => (list.length === 0 ? "两个算例相同。"
    : `更改：${list.map(([key, a, b]) => `${key} 从 ${a ?? "默认值"} 到 ${b ?? "默认值"}`).join("，")}。`),
  compareColumns: ["物理量", "A", "B", "变化", "区间"],
  verdict: (verdict) => verdicts[verdict],

  sweep: "扫描",
  sweepAbout: "依次用一个参数的多个值计算算例。",
  sweepKey: "参数",
  sweepFrom: "从",
  sweepTo: "到",
  sweepCount: "取值个数",
  sweepSpacing: "间隔",
  spacings: [["lin", "等差"], ["log", "等比"]],
  sweepQuantity: "物理量",
  sweepCurve: "扫描曲线",
  runSweep: "运行扫描",
  saveSweep: "下载 sweep.csv",
  sweepWaits: "正在进行计算；请停止它，或等待其结束。",
  sweepFault: "“从”和“到”必须是数字；等比时两者都要大于 0。",
  sweepStatus: (state, at, count) => state === "done" ? `完成：${count} 个值。`
    : state === "stopped" ? `在 ${count} 个值中的 ${at} 个之后停止。`
      : `正在计算第 ${Math.min(at + 1, count)} 个值，共 ${count} 个。`,

  report: "全部图表",
  noReport: "计算结束后，这里显示含有全部图表的报告。",

  about: "关于这些数字",
  trust: "区间只包含模拟的统计波动：计算越长，区间越窄。它不包含模型的误差，也不包含未测量值的误差。" +
    "同一台磨机两种设定之间的差别比绝对数值更可靠。",
  noticesInFull: (count) => (count === 1 ? "查看完整提示" : `查看全部 ${count} 条提示`),
  replicateStopped: (number, reason) => `第 ${number} 次重复被停止：${reason}`,
  noNotices: "程序对此算例没有提示。",
  severity: (severity) => severities[severity] ?? `${severity}：`,
  guessed: "假定且未校准：",
  assumed: "假定值",
  assumedAbout: "算例没有给出这些值，程序采用了默认值。",
  unverified: "未核实的值",
  unverifiedAbout: "目录中来源薄弱或无人核对的值。",
  originColumns: ["参数", "值", "来源"],
  repeat: "用程序重复此计算",
  repeatAbout: "将算例保存为 case.toml。同一版本的程序给出相同的数字：",
  copy: "复制",
  copied: "已复制",
  downloadCase: "下载 case.toml",

  files: "文件",
  filesAbout: "此结果的文件。",
  filesHint: "计算结束后，结果的文件显示在这里。",
  openResult: "打开结果或算例",
  openAbout: "程序的结果：选择 summary.json 及其旁边的文件，或把文件夹拖到页面上。也可以显示参数扫描、拟合或优化的页面（campaign.html 等）。",
  opened: (title) => `已打开：${title}。`,
  openedStudy: "已打开：研究的页面，在下方“全部图表”中。",
  openedCase: "此算例来自文件。点击“运行”开始计算。",
  nothingToOpen: "这些文件中既没有 summary.json，也没有算例（.toml）。",
  cannotOpen: (why) => `无法显示此结果：${why}`,

  follow: "随更改运行",
  followAbout: "更改后的算例会取代正在计算的算例。如果上次计算用时不超过 30 s，更改也会启动下一次计算。暂停或停止后不会自动启动",

  history: "历史",
  historyAbout: "本次会话的结果，最新的在前，最多 20 个。关闭页面后它们会消失，除非您保存：保存的结果留在本设备的此浏览器中。",
  historyDenied: "本次会话的结果，最新的在前，最多 20 个。此浏览器不允许页面保存任何内容，关闭页面后它们会消失：请下载需要的内容。",
  nameOfCase: "名称",
  saveThisCase: "保存此算例",
  savedAs: (name) => `已在此浏览器中保存为“${name}”。`,
  notSaved: (reason) => reason === "full" ? "未保存：此浏览器已没有空间。请先删除一个已保存的条目。"
    : reason === "denied" ? "此浏览器不允许页面保存任何内容：名称只在关闭页面前有效。"
      : `未保存：${reason}`,
  nameOfEntry: "新名称",
  ok: "确定",
  entryAbout: ({ date, saved }) => `${new Date(date).toLocaleString("zh-CN", { dateStyle: "medium", timeStyle: "medium" })}，` +
    (saved ? "已保存" : "本次会话"),
  entryChange: (changes) => `与前一个结果相比：${changes.map(([key, to]) => `${key} = ${to ?? "默认值"}`).join("，")}`,
  entryChoice: ({ name, date, change }) => [name, new Date(date).toLocaleTimeString("zh-CN"),
    ...change.slice(0, 2).map(([key, to]) => `${key} = ${to ?? "默认值"}`)].join("，"),
  onlyCase: "没有结果的算例。",
  open: "打开",
  openEntry: (name) => `打开 ${name}`,
  openedEntry: "这是您保存的算例。点击“运行”开始计算。",
  rename: "重命名",
  renameEntry: (name) => `重命名 ${name}`,
  saveEntry: "保存",
  saveEntryAbout: (name) => `为 ${name} 命名并保存`,
  downloadCaseOf: (name) => `下载 ${name} 的 case.toml`,
  downloadSummaryOf: (name) => `下载 ${name} 的 summary.json`,
  delete: "删除",
  deleteEntry: (name) => `删除 ${name}`,
  compareGroup: "作为 A 或 B 比较",
  compareAs: (side, name) => `作为 ${side} 比较：${name}`,
  noA: "没有结果",
  newestAsB: "最新结果",

  embed: "将此算例嵌入其他网页：",
  embedAbout: "嵌入框显示动画、主要数字和“运行”；用 #embed&amp;run&amp; 代替 #embed&amp; 则立即计算。",
  openInFull: "打开完整页面",
  close: "关闭",
};
