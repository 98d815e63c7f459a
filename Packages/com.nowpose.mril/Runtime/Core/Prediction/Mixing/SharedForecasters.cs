namespace Nowpose.Prediction.Mixing
{
    /// <summary>
    /// Forecasters that the joints of one robot, or the objects of one cell, use in turn. Their weights are then computed once per message, and their memory stays in
    /// the processor's cache. Not thread-safe.
    /// </summary>
    sealed class SharedForecasters
    {
        /// <summary>The forecasters of the mixture, equal for all of them; null until the first predictor creates them.</summary>
        public MixedForecasters Mixed { get; set; }
    }
}
