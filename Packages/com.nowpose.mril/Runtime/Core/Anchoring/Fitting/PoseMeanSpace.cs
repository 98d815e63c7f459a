using System;

namespace Nowpose.Anchoring.Fitting
{
    /// <summary>Buffers for the computation of a <see cref="PoseMean"/>, so that it does not allocate them.</summary>
    sealed class PoseMeanSpace
    {
        readonly double[] _sorted = new double[PoseWindow.Capacity];

        public double[] Distances { get; } = new double[PoseWindow.Capacity];
        public double[] Angles { get; } = new double[PoseWindow.Capacity];
        public double[] Weights { get; } = new double[PoseWindow.Capacity];

        /// <param name="count">One or more.</param>
        public double MedianOf(double[] values, int count)
        {
            Array.Copy(values, _sorted, count);
            Array.Sort(_sorted, 0, count);
            return (_sorted[(count - 1) / 2] + _sorted[count / 2]) / 2;
        }
    }
}
