using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>Keeps the times and positions of the newest samples, newest first; the components of a position are adjacent.</summary>
    sealed class PositionWindow
    {
        readonly int _components;

        public PositionWindow(int samples, int components)
        {
            _components = components;
            (Times, Positions) = (new double[samples], new double[samples * components]);
        }

        /// <summary>Number of samples.</summary>
        public int Count { get; private set; }

        /// <summary>Times in s.</summary>
        public double[] Times { get; }

        public double[] Positions { get; }

        public void Add(double time, ReadOnlySpan<double> position)
        {
            Count = Math.Min(Count + 1, Times.Length);
            Array.Copy(Times, 0, Times, 1, Count - 1);
            Array.Copy(Positions, 0, Positions, _components, (Count - 1) * _components);
            Times[0] = time;
            position.CopyTo(Positions);
        }

        public void Clear() => Count = 0;
    }
}
