namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Weights that the predictors of one robot's joints, or of one object's coordinates, share. Not thread-safe.</summary>
    sealed class SharedWeights
    {
        /// <summary>Gets the weights of the quadratic through five samples.</summary>
        public PositionWeights Quadratic { get; } = new PolynomialWeights(2, 4);

        /// <summary>Gets the weights of the cubic through four samples.</summary>
        public PositionWeights Cubic { get; } = new PolynomialWeights(3, 3);

        /// <summary>Gets the weights of the Gaussian process.</summary>
        public PositionWeights Process { get; } = new GaussianProcess();
    }
}
