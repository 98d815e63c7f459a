using System;

namespace Nowpose.Anchoring.Fitting
{
    /// <summary>Where a <see cref="PoseMean"/> is worked out, so that it needs no memory of its own.</summary>
    sealed class PoseMeanSpace
    {
        readonly double[] _sorted = new double[PoseWindow.Capacity];

        public double[] Distances { get; } = new double[PoseWindow.Capacity];
        public double[] Angles { get; } = new double[PoseWindow.Capacity];
        public double[] Weights { get; } = new double[PoseWindow.Capacity];

        /// <param name="count">At least one.</param>
        public double MedianOf(double[] values, int count)
        {
            Array.Copy(values, _sorted, count);
            Array.Sort(_sorted, 0, count);
            return (_sorted[(count - 1) / 2] + _sorted[count / 2]) / 2;
        }
    }
}
