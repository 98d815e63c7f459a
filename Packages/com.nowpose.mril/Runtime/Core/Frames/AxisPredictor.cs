using System;
using Nowpose.Prediction;

namespace Nowpose.Frames
{
    /// <summary>Predicts one component of a vector, starting at its first change.</summary>
    /// <remarks>
    /// Many components never change, for example the height of a workpiece on a conveyor, or two of the three angles of a turntable. Their values
    /// need no prediction. Allocates nothing after construction.
    /// </remarks>
    sealed class AxisPredictor
    {
        /// <summary>Maximum difference from the first value that counts as rounding, in m or rad.</summary>
        const double Rounding = 1e-9;

        /// <summary>
        /// Number of samples kept before the first change. From these samples, the predictor recognises that the motion starts from rest.
        /// </summary>
        const int Kept = 8;

        readonly JointPredictor _predictor;
        readonly bool _waitsForChange;
        readonly JointSample[] _newestFirst = new JointSample[Kept];
        double _value;
        int _count;
        bool _hasChanged;

        /// <param name="waitsForChange">Whether the prediction starts only at the first change.</param>
        public AxisPredictor(JointPredictor predictor, bool waitsForChange)
        {
            _predictor = predictor;
            _waitsForChange = waitsForChange;
            Reset();
        }

        /// <summary>Value of the newest sample; 0 before the first sample.</summary>
        public double Hold => _hasChanged ? _predictor.Hold : _value;

        /// <inheritdoc cref="JointPredictor.Restarts"/>
        public int Restarts => _predictor.Restarts;

        /// <inheritdoc cref="JointPredictor.Add"/>
        public DropReason Add(in JointSample sample, double displayed)
        {
            if (_hasChanged) return _predictor.Add(sample, displayed);
            if (_count == 0) _value = sample.Position;
            if (Math.Abs(sample.Position - _value) <= Rounding)
            {
                if (_count == 0 || sample.Order > _newestFirst[0].Order) Keep(sample);
                return DropReason.None;
            }
            _hasChanged = true;
            // Adds each kept sample with the display time at its arrival, because the predictor uses this time to estimate the horizon.
            for (var age = _count - 1; age >= 0; age--) _predictor.Add(_newestFirst[age], displayed - (sample.Time - _newestFirst[age].Time));
            return _predictor.Add(sample, displayed);
        }

        public double At(double time) => _hasChanged ? _predictor.At(time).Position : _value;

        public void Reset()
        {
            _predictor.Reset();
            (_value, _count, _hasChanged) = (0, 0, !_waitsForChange);
        }

        void Keep(in JointSample sample)
        {
            _count = Math.Min(_count + 1, Kept);
            for (var age = _count - 1; age > 0; age--) _newestFirst[age] = _newestFirst[age - 1];
            _newestFirst[0] = sample;
        }
    }
}
