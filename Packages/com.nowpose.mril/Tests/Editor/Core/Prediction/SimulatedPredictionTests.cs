using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction
{
    public class SimulatedPredictionTests
    {
        const int Seed = 7;

        static double Ratio(string predictor, double sampling = 0.05, double latency = 0.1, double stampError = 0) =>
            new SimulatedPrediction { SamplingInterval = sampling, Latency = latency, StampError = stampError }
                .Ratio(predictor, Seed);

        // Expected values: an independent simulation in Python of the paper's Figs 13 and 14.
        [TestCase("hold", 1)]
        [TestCase("linear", 0.374)]
        [TestCase("quadratic", 0.254)]
        [TestCase("cubic", 0.271)]
        [TestCase("quadratic-h3", 0.328)]
        [TestCase("quadratic-h4", 0.404)]
        public void Ratio_SamplingOf50MsAndLatencyOf100Ms_MatchesFigures13And14(string predictor, double expected)
        {
            Assert.That(Ratio(predictor), Is.EqualTo(expected).Within(0.02), "seed " + Seed);
        }

        [TestCase(0.02, 0.1, "linear", 0.280)]
        [TestCase(0.02, 0.1, "quadratic", 0.136)]
        [TestCase(0.02, 0.1, "cubic", 0.105)]
        [TestCase(0.1, 0.1, "quadratic", 0.477)]
        [TestCase(0.1, 0.1, "cubic", 0.646)]
        [TestCase(0.1, 0.1, "quadratic-h3", 0.604)]
        [TestCase(0.05, 0, "quadratic", 0.084)]
        [TestCase(0.05, 0.25, "quadratic", 0.621)]
        [TestCase(0.05, 0.25, "cubic", 0.938)]
        public void Ratio_OtherIntervalsAndLatencies_MatchesFigures13And14(
            double sampling, double latency, string predictor, double expected)
        {
            Assert.That(Ratio(predictor, sampling, latency), Is.EqualTo(expected).Within(0.02), "seed " + Seed);
        }

        [TestCase(0.005, "linear", 0.391)]
        [TestCase(0.005, "quadratic", 0.431)]
        [TestCase(0.005, "quadratic-h3", 0.378)]
        [TestCase(0.010, "quadratic-h4", 0.475)]
        public void Ratio_StampErrors_MatchesFigures13dAnd14d(double stampError, string predictor, double expected)
        {
            Assert.That(Ratio(predictor, stampError: stampError), Is.EqualTo(expected).Within(0.03), "seed " + Seed);
        }

        [Test]
        public void Ratio_CubicAndQuadratic_CubicIsBetterOnlyWithFastSampling()
        {
            Assert.That(Ratio("cubic", sampling: 0.02), Is.LessThan(Ratio("quadratic", sampling: 0.02)));
            Assert.That(Ratio("cubic", sampling: 0.1), Is.GreaterThan(Ratio("quadratic", sampling: 0.1)));
        }

        [Test]
        public void Ratio_HistoriesOfSeveralLengths_LongerOnesAreBetterOnlyWithLargeStampErrors()
        {
            Assert.That(Ratio("quadratic-h3", stampError: 0.003), Is.GreaterThan(Ratio("quadratic", stampError: 0.003)));
            Assert.That(Ratio("quadratic-h3", stampError: 0.005), Is.LessThan(Ratio("quadratic", stampError: 0.005)));
            Assert.That(Ratio("quadratic-h4", stampError: 0.007), Is.GreaterThan(Ratio("quadratic-h3", stampError: 0.007)));
            Assert.That(Ratio("quadratic-h4", stampError: 0.010), Is.LessThan(Ratio("quadratic-h3", stampError: 0.010)));
        }
    }
}
