using Nowpose.Prediction.Forecasting;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>A forecaster of the mixture and its prior weight. The weights of all forecasters add up to one.</summary>
    readonly struct MixedForecaster
    {
        /// <param name="prior">Weight, 0 to 1.</param>
        /// <param name="priorWhenReported">Weight if samples contain their acceleration.</param>
        public MixedForecaster(Forecaster forecaster, double prior = 0, double priorWhenReported = 0)
        {
            Forecaster = forecaster;
            Prior = prior;
            PriorWhenReported = priorWhenReported;
        }

        public Forecaster Forecaster { get; }

        public double Prior { get; }

        public double PriorWhenReported { get; }
    }
}
