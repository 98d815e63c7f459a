using System;
using Nowpose.Prediction.Forecasting;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>
    /// Forecasts that the present motion continues in the same way as an earlier, similar motion, for machines that repeat their motion.
    /// </summary>
    /// <remarks>
    /// Without a similar motion (<see cref="TemplateMatcher"/>), it has no forecast. A <see cref="CandidateGate"/> decides whether the forecast is
    /// used.
    /// </remarks>
    sealed class TemplateForecaster : Forecaster
    {
        readonly TemplateMatcher _matcher;
        double _newestTime;
        double _newestPosition;

        /// <inheritdoc cref="TemplateMatcher(int, double, double)"/>
        public TemplateForecaster(double maximumGap, double matchInterval) => _matcher = new TemplateMatcher(1, maximumGap, matchInterval);

        public override int Samples => 2;

        /// <returns>False if the history contains no similar motion.</returns>
        public override bool Solve(MotionState motion)
        {
            // An overtaken sample is too late for the history.
            if (motion.IsNewest)
            {
                (_newestTime, _newestPosition) = (motion.Samples.NewestTime, motion.Samples[0].Position);
                Span<double> position = stackalloc[] { _newestPosition };
                _matcher.Add(_newestTime, position, motion.MeanInterval, motion.Rest.Standstill);
            }
            return _matcher.HasMatch;
        }

        public override double At(double ahead)
        {
            Span<double> position = stackalloc double[1];
            _matcher.At(_newestTime + ahead, position);
            return position[0] - _newestPosition;
        }

        public override void Reset() => _matcher.Reset();
    }
}
