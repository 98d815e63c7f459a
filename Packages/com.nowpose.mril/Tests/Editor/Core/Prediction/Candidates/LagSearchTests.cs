using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Nowpose.Prediction.Candidates;

namespace Nowpose.Tests.Core.Prediction.Candidates
{
    /// <summary>Tests at which samples the search passes over all lags.</summary>
    public class LagSearchTests
    {
        const double Step = 0.05;

        /// <summary>Number of samples between two passes at this step.</summary>
        const int Stride = 4;

        [Test]
        public void Update_MotionsThatAreSampledTogether_PassAtDifferentSamples()
        {
            var passes = Enumerable.Range(0, Stride).Select(turn => PassesOf(turn).Distinct().ToArray()).ToArray();

            Assert.That(passes, Has.All.Length.EqualTo(1), "a pass at each fourth sample");
            Assert.That(passes.SelectMany(each => each), Is.Unique);
        }

        // Numbers of the samples, modulo the stride, after which the best lags are others. In a random motion, nearly each pass finds others.
        static IEnumerable<int> PassesOf(int turn)
        {
            var (history, random) = (new MotionHistory(1), new Random(7301));
            var search = new LagSearch(history, turn);
            history.Start(Step);
            search.Start();
            var (lags, position) = (new int[LagSearch.Kept], 0.0);
            for (var i = 0; i < 400; i++)
            {
                position += random.NextDouble() - 0.5;
                history.Add(i * Step, new[] { position });
                search.Update(minLag: 14);
                if (!lags.SequenceEqual(search.Lags)) yield return i % Stride;
                lags = (int[])search.Lags.Clone();
            }
        }
    }
}
