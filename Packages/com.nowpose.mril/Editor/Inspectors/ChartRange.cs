using System;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Value range of a chart. It has round limits and contains zero and all known values.</summary>
    readonly struct ChartRange
    {
        ChartRange(float bottom, float top)
        {
            Bottom = bottom;
            Top = top;
        }

        public float Bottom { get; }
        public float Top { get; }

        public static ChartRange Of(RollingSeries series)
        {
            if (!series.TryGetRange(out var min, out var max)) return new ChartRange(0, 1);
            var top = max > 0 ? Round(max) : 0;
            var bottom = min < 0 ? -Round(-min) : 0;
            return top > bottom ? new ChartRange(bottom, top) : new ChartRange(0, 1);
        }

        /// <summary>Returns the position of a value in the range, from 0 at the bottom to 1 at the top.</summary>
        public float PartOf(float value) => (value - Bottom) / (Top - Bottom);

        // Rounds up to 1, 2 or 5 times a power of ten, so that small changes of the values do not change the scale.
        static float Round(float value)
        {
            var power = Math.Pow(10, Math.Floor(Math.Log10(value)));
            foreach (var step in new[] { 1, 2, 5 })
                if (value <= step * power * 1.0001) return (float)(step * power);
            return (float)(10 * power);
        }
    }
}
