using System;
using System.Linq;
using Nowpose.Latency;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency
{
    /// <summary>A monitor of the render time and the display that it is compared with.</summary>
    static class MonitoredDisplay
    {
        public const RenderTimeSourceKind Source = RenderTimeSourceKind.DisplayGpuTime;
        public static readonly DisplayPipelineSettings Display = new DisplayPipelineSettings();
        public static readonly double Limit = Display.RefreshMs - DisplayPipelineSettings.LatchMs;
        public static readonly int[] Seeds = Enumerable.Range(1, 20).ToArray();

        public static ConstantLatencyMonitor Monitor() => Monitor(Limit);

        public static ConstantLatencyMonitor Monitor(double limitMs) =>
            new ConstantLatencyMonitor(new ConstantLatencyRange(limitMs, Source));

        public static void Add(ConstantLatencyMonitor monitor, double renderMs, int frames = 1, RenderTimeSourceKind source = Source)
        {
            for (var i = 0; i < frames; i++) monitor.Add(TimeSpan.FromTicks((long)(renderMs * TimeSpan.TicksPerMillisecond)), source);
        }

        // Returns the number of state changes per minute for the monitor and, for comparison, for a rule that judges each frame alone.
        public static (double Monitor, double SingleFrame) FlipsPerMinute(double renderMs, int seed, double minutes)
        {
            var monitor = Monitor();
            var display = new DisplayPipeline(seed);
            var (flips, singleFlips, wasOutside, wasSingle) = (0, 0, false, false);
            for (var frame = 0; frame < minutes * 3600; frame++)
            {
                var render = display.Next(Display.VerticesOf(renderMs)).RenderTime.TotalMilliseconds;
                Add(monitor, render);
                var (isOutside, isSingle) = (monitor.State == RangeState.Outside, render > Limit);
                if (isOutside != wasOutside) flips++;
                if (isSingle != wasSingle) singleFlips++;
                (wasOutside, wasSingle) = (isOutside, isSingle);
            }
            return (flips / minutes, singleFlips / minutes);
        }
    }
}
