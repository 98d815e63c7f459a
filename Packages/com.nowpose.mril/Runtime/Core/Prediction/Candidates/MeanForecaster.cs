using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>Forecasts the mean of the newest samples while they only scatter.</summary>
    /// <remarks>
    /// The other forecasters would amplify the noise. A slow motion that is hidden in the noise leaves the mean behind, for which the gate rejects it.
    /// </remarks>
    sealed class MeanForecaster : Forecaster
    {
        RestDetector _rest;

        public override bool Solve(MotionState motion)
        {
            _rest = motion.Rest;
            return _rest.Scatters;
        }

        public override double At(double ahead, int component) => _rest.Mean[component];
    }
}
