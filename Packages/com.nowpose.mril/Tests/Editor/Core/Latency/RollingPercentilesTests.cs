using System;
using System.Collections.Generic;
using System.Linq;
using MathNet.Numerics.Statistics;
using Nowpose.Latency;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency
{
    public class RollingPercentilesTests
    {
        [Test]
        public void At_RandomLengths_EqualsTheQuantileOfTheWindow()
        {
            const int window = 50;
            var random = new Random(1);
            var rolling = new RollingPercentiles(window);
            var all = new List<double>();
            for (var i = 0; i < 500; i++)
            {
                // There are few distinct values, so a value often leaves the window while an equal value stays in it.
                var length = random.Next(-5, 20);
                all.Add(length);
                rolling.Add(new TimeSpan(length * 1000));

                var recent = all.Skip(Math.Max(0, all.Count - window)).ToArray();
                foreach (var fraction in new[] { 0, 0.5, 0.95, 1 })
                    Assert.That(rolling.At(fraction).Ticks / 1000.0,
                        Is.EqualTo(recent.QuantileCustom(fraction, QuantileDefinition.R7)).Within(1e-3), "seed 1, length " + i);
            }
        }
    }
}
