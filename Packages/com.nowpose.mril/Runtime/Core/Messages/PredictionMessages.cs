using System;
using Nowpose.Prediction.Forecasting;

namespace Nowpose.Messages
{
    /// <summary>Error messages about samples, plans and predictors.</summary>
    static class PredictionMessages
    {
        public const string NegativeSeconds = "must be 0 s or more";

        public static string NotFinite(double time, double position, double order) =>
            FormattableString.Invariant($"time, position and order must be finite; they are {time} s, {position}, {order} s");

        public static string PositionCount(int positions, int times) =>
            $"{positions} positions for {times} times; the counts must be equal and at least 1";

        public static string DerivativeCount(int times) => $"the numbers of velocities and accelerations must equal the number of times, {times}";
        public static string TimeOrder(int index, double time, double earlier) =>
            FormattableString.Invariant($"time {index}: {time} s is not later than {earlier} s; times must increase");
        public static string LimitOrder(double lower, double upper) =>
            FormattableString.Invariant($"position limits {lower} to {upper}: lower must not exceed upper");
        public static string LimitsOfContinuousJoint(double lower, double upper) =>
            FormattableString.Invariant($"position limits {lower} to {upper}: a continuous joint must have no position limits");

        public const string NotPositiveSeconds = "must be more than 0 s";

        public static string NotPositive(string unit) => $"must be more than 0 {unit}";

        public static string UnknownPredictor(string name, string allowed) =>
            FormattableString.Invariant($"predictor '{name}' is unknown; allowed: {allowed}, or a polynomial with a history from its degree to ")
            + FormattableString.Invariant($"{PolynomialForecaster.MaxHistory}, for example linear-h4");
    }
}
