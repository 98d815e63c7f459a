namespace Nowpose.Prediction.Gating
{
    /// <summary>How two predictors did lately, in mean squares that forget.</summary>
    sealed class ForecastRecord
    {
        /// <summary>What the record keeps per score.</summary>
        const double Keeping = 0.85;

        readonly double _shareOfSquare;
        readonly int _fewestScores;
        double _candidateSquare;
        double _fallbackSquare;
        int _scores;

        /// <param name="shareOfSquare">The candidate's mean square must be below this share of the other's.</param>
        /// <param name="fewestScores">More scores than this are needed.</param>
        public ForecastRecord(double shareOfSquare, int fewestScores)
        {
            _shareOfSquare = shareOfSquare;
            _fewestScores = fewestScores;
        }

        /// <summary>Whether the candidate was clearly better, often enough to believe it.</summary>
        public bool FavoursCandidate => _scores > _fewestScores && _candidateSquare < _shareOfSquare * _fallbackSquare;

        public void Add(double candidateError, double fallbackError)
        {
            // Nothing beyond the range of numbers may stay in the means.
            if (!(candidateError * candidateError + fallbackError * fallbackError < double.PositiveInfinity)) return;
            _candidateSquare = Keeping * _candidateSquare + (1 - Keeping) * candidateError * candidateError;
            _fallbackSquare = Keeping * _fallbackSquare + (1 - Keeping) * fallbackError * fallbackError;
            _scores++;
        }

        public void Reset()
        {
            _candidateSquare = _fallbackSquare = 0;
            _scores = 0;
        }
    }
}
