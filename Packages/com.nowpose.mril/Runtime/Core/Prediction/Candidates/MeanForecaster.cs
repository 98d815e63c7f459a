using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>Forecasts the mean of the newest samples while they only scatter, as those of a noisy tracker or encoder at rest.</summary>
    /// <remarks>
    /// The other forecasters would amplify the noise. A slow motion that is hidden in the noise leaves the mean behind, for which the gate rejects it.
    /// </remarks>
    sealed class MeanForecaster : Forecaster
    {
        readonly ScatterDetector _scatter;

        /// <param name="scatter">The mixture's detector, which has examined the sample before this forecaster is solved.</param>
        public MeanForecaster(ScatterDetector scatter) => _scatter = scatter;

        public override bool Solve(MotionState motion) => _scatter.Scatters;

        public override double At(double ahead, int component) => _scatter.Mean[component];
    }
}
