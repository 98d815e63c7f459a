using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>Keeps the positions of the newest samples, newest first; the components of a position are adjacent.</summary>
    sealed class PositionWindow
    {
        readonly int _samples, _components;

        public PositionWindow(int samples, int components) =>
            (_samples, _components, Positions) = (samples, components, new double[samples * components]);

        /// <summary>Number of samples.</summary>
        public int Count { get; private set; }

        public double[] Positions { get; }

        public void Add(ReadOnlySpan<double> position)
        {
            Count = Math.Min(Count + 1, _samples);
            Array.Copy(Positions, 0, Positions, _components, (Count - 1) * _components);
            position.CopyTo(Positions);
        }

        public void Clear() => Count = 0;
    }
}
