using System;
using Nowpose.Session.Hindcast;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    public class ErrorRunTests
    {
        [Test]
        public void Reset_AfterManyFrames_HasTheErrorsOfANewRun()
        {
            var (reset, unused) = (new ErrorRun(), new ErrorRun());
            Add(reset, 5000, 1);
            reset.Reset();

            Add(reset, 1000, 0.3);
            Add(unused, 1000, 0.3);

            Assert.That(reset.Read().Value.ReductionUncertainty, Is.GreaterThan(0));
            Assert.That(reset.Read(), Is.EqualTo(unused.Read()));
        }

        static void Add(ErrorRun run, int frames, double factor)
        {
            for (var i = 0; i < frames; i++)
                run.Add(new ErrorSums(1e-4 * factor * (1 + Math.Sin(i)), 1e-2 * (2 + Math.Sin(0.01 * i)), 1e-8, 1e-6));
        }
    }
}
