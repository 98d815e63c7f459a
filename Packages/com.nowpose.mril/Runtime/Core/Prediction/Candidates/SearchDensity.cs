namespace Nowpose.Prediction.Candidates
{
    /// <summary>Intervals at which <see cref="TemplateForecaster"/> searches for a repeated motion, and step between the compared lags.</summary>
    /// <remarks>
    /// The search takes more than half of the computing time per sample. For 1 332 simulated motions of objects, the sparse search increased the
    /// errors of positions by 2.0 % and those of rotations by 0.4 % (geometric means). The ablation study lists the effect on joints.
    /// </remarks>
    sealed class SearchDensity
    {
        /// <summary>
        /// For joints. With a compare interval of 0.15 s, the errors on recordings are 0.1 % smaller, and the passes take a third more time.
        /// With a lag step of 0.1 s, the error of an exact repetition at 50 ms is three times as large.
        /// </summary>
        public static readonly SearchDensity Dense = new SearchDensity(compareInterval: 0.2, lagStep: 0.06, matchInterval: 0.035);

        /// <summary>For tracked objects: six coordinates each, and many objects in a cell.</summary>
        public static readonly SearchDensity Sparse = new SearchDensity(compareInterval: 0.3, lagStep: 0.1, matchInterval: 0.14);

        SearchDensity(double compareInterval, double lagStep, double matchInterval) =>
            (CompareInterval, LagStep, MatchInterval) = (compareInterval, lagStep, matchInterval);

        /// <summary>Interval between the compared grid points, in s. Each of them requires a pass over all lags.</summary>
        public double CompareInterval { get; }

        /// <summary>Maximum step between compared lags, in s. <see cref="MotionOverlay"/> finds the exact lag near them.</summary>
        public double LagStep { get; }

        /// <summary>Minimum interval between two comparisons with the history, in s; samples between them keep the last matches.</summary>
        public double MatchInterval { get; }
    }
}
