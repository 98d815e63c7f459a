using Nowpose.Prediction.Forecasting;

namespace Nowpose.Frames
{
    /// <summary>Detects abrupt changes in the velocity of a vector, also after a constant velocity.</summary>
    /// <remarks>Allocates nothing after construction.</remarks>
    sealed class VectorChangePoints
    {
        /// <summary>
        /// Maximum change of a constant velocity, relative to the maximum recent speed. While the velocity is constant, the samples before it are left
        /// out: without noise, a conveyor or turntable that is switched on moves at full speed at once, and a fit across the start would overshoot.
        /// Without this rule, turntables with abrupt starts had up to 1.3 times the error of the line. With 1e-3, the errors on such motions are the same,
        /// but workpieces of a UR5, whose smooth moves are almost uniform at times, have up to 3.5 % larger errors.
        /// </summary>
        const double SteadyRatio = 1e-6;

        readonly BodyPart _part;
        Vector3D _speed;
        double _intervalBefore;
        int _steadySamples;
        bool _wasSteady;

        public VectorChangePoints(BodyPart part) => _part = part;

        public ChangePointDetector Detector { get; } = new ChangePointDetector();

        /// <summary>Adds the newest sample.</summary>
        /// <param name="hasJumped">Whether it is at another place. The velocity before the jump then remains.</param>
        public void Add(BodySamples samples, bool hasJumped)
        {
            if (hasJumped)
            {
                Detector.AddJump();
                return;
            }
            var (history, interval, before) = (samples.History, samples.Timing.Interval, _speed);
            if (history.Count > 1) _speed = (history[0][_part] - history[1][_part]) * (1 / interval);
            var speeds = new SpeedChange(_speed.Length, before.Length, (_speed - before).Length, _speed.Dot(before));
            // An abrupt change within an interval shows in the velocity of two intervals.
            var wasSteady = _steadySamples > 0 || _wasSteady;
            _wasSteady = _steadySamples > 0;
            _steadySamples = speeds.Change <= SteadyRatio * Detector.MaxSpeed ? _steadySamples + 1 : 0;
            Detector.Add(history.Count, interval, _intervalBefore, speeds, wasSteady);
            if (_steadySamples > 0) Detector.KeepNewest(_steadySamples + 2);
            _intervalBefore = interval;
        }

        public void Reset()
        {
            Detector.Reset();
            _speed = default;
            _intervalBefore = _steadySamples = 0;
            _wasSteady = false;
        }
    }
}
