// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// 动画的全部中文文字，供传入它们的页面使用（web/src/text/zh.js）。

import { grouped } from "./en.js";

const ballsShown = ({ count, of }) => of > count
  ? `${grouped(of)} 个磨球中的 ${grouped(count)} 个（${Math.round(of / count) > 1
    ? `每 ${Math.round(of / count)} 个显示一个` : "未显示全部"}）`
  : `${grouped(count)} 个磨球`;
const carriers = { disc: { name: "转盘", about: "以转盘为参考系，随其绕磨机轴转动" } };

export const zh = {
  replay: (title) => `动画：${title}`,
  picture: (title) => `运动罐中的磨球：${title}。拖动旋转，按住 Shift 拖动平移，滚轮或双指缩放。` +
    "按键：空格播放或暂停，方向键单步，v 切换视图，c 切换颜色，h 显示或隐藏碰撞，加减号缩放，Shift 加方向键旋转。",
  keys: [" 拖动旋转，", "空格", " 播放，", "\u2190", " ", "\u2192", " 单步，", "v", " 视图，", "c",
    " 颜色，", "h", " 碰撞。点击选择磨球，", "b", " 下一个。"],

  play: "播放",
  pause: "暂停",
  back: "后退一帧",
  forward: "前进一帧",
  time: "时间",
  simulatedTime: "模拟时间",
  pace: "播放速度",
  paceLabel: "动画的播放速度",
  paceAbout: "模拟时间与实际时间之比",
  loop: "循环",
  realTime: (factor) => `${factor}x 实时`,

  view: "视图",
  views: {
    laboratory: { name: "实验室", about: "以实验室为参考系" },
    centre: { name: "罐中心", about: "以罐中心为参考系，不转动" },
    fixed: { name: "固定罐", about: "以罐为参考系，随其转动" },
  },
  carrier: (name) => carriers[name] ?? { name: name[0].toUpperCase() + name.slice(1),
    about: `以 ${name} 为参考系，随其绕磨机轴转动` },

  colour: "颜色",
  colours: {
    speed: { name: "速度", about: "相对于罐中心的速度", scale: (unit) => `相对于罐中心的速度（${unit}）` },
    spin: { name: "自转", about: "磨球绕自身中心的角速度", scale: (unit) => `自转角速度（${unit}）` },
    energy: { name: "能量", about: "按相对于罐中心的速度计算的平动动能，不含自转能量", scale: (unit) => `平动动能（${unit}）` },
    species: { name: "种类", about: "每种磨球一种颜色" },
  },

  hits: "碰撞",
  hitsAbout: "闪示最强的碰撞。圆环越大越红，碰撞能量（法向）越大",
  hitsScale: "碰撞，碰撞能量",

  camera: "视角",
  directions: {
    start: { name: "初始", about: "初始视角" },
    axis: { name: "沿轴", about: "沿罐轴线观察" },
    side: { name: "侧面", about: "从侧面观察" },
  },

  save: "保存",
  savePicture: "图片",
  savePictureAbout: "以两倍分辨率将此图保存为 PNG",
  saveVideo: "视频",
  saveVideoAbout: "将整个动画保存为视频",
  stop: "停止",
  recording: (seconds) => `正在录制：动画播放一次，${seconds} s。请保持页面可见。`,
  videoFailed: (why) => `无法录制视频：${why}。`,
  recorderStopped: "录制已停止",
  noRecorder: "此浏览器不能录制视频",
  noFrames: "浏览器没有录到画面，放慢播放可能有用",
  noVideoFormat: "此浏览器不支持任何录制视频的格式",

  caption: (data, from, to, view) => `${ballsShown(data)}，${data.frames > 1
    ? `${grouped(data.frames)} 帧，从 ${from} 到 ${to}` : `${from} 时的一帧`}，${view}。`,
  picked: ({ number, body, kind }) => `${body ? "子球" : "磨球"} ${grouped(number)}${kind ? `，${kind}` : ""}`,
  hitsOf: (count, span) => `${span} 内 ${grouped(count)} 次碰撞`,
  weight: "g",

  noWebGL: "动画需要 WebGL 2，此浏览器不支持或已禁用。没有动画，所有数字仍然完整。",
  dataFault: (what) => `无法显示动画数据：${what}；请用写此页面的 mahlwerk 版本重新生成报告。`,
  dataFaults: {
    missing: (name) => `缺少 "${name}"`,
    notBase64: (name) => `"${name}" 不是 base64`,
    length: (name, found, expected) => `"${name}" 有 ${found} 字节，应为 ${expected}`,
    multiple: (name, found, size) => `"${name}" 有 ${found} 字节，不是 ${size} 的倍数`,
    notPositive: (name, value) => `"${name}" 必须大于 0，而不是 ${value}`,
    corners: (name) => `"${name}.triangles" 引用了 "${name}.vertices" 中没有的顶点`,
    bodies: (name, count, first, spheres) => `"${name}" 从第 ${first} 个球起有 ${count} 个物体，共 ${spheres} 个球`,
    noTimes: () => '"times" 缺失或为空',
    times: () => '"times" 中的数必须递增',
    notJson: (why) => `不是 JSON（${why}）`,
    version: (found) => `版本为 ${found}，但此页面读取版本 1`,
    count: (found) => `"count" 必须是整数，而不是 ${found}`,
  },
};
