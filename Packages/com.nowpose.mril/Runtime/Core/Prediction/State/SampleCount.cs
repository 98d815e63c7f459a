using System;

namespace Nowpose.Prediction.State
{
    /// <summary>Counts samples over any time, without an overflow.</summary>
    static class SampleCount
    {
        /// <summary>Returns the next number; the largest one stays.</summary>
        public static int Next(int count) => Math.Min(count, int.MaxValue - 1) + 1;
    }
}
