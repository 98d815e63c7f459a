using System;
using System.Collections.Generic;
using Nowpose.Latency;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency
{
    public class RenderTimeChoiceTests
    {
        const RenderTimeSourceKind Gpu = RenderTimeSourceKind.DisplayGpuTime;
        const RenderTimeSourceKind Engine = RenderTimeSourceKind.EngineGpuTime;
        const RenderTimeSourceKind Completion = RenderTimeSourceKind.GpuCompletion;
        const RenderTimeSourceKind Cpu = RenderTimeSourceKind.CameraCpu;
        const RenderTimeSourceKind Nothing = RenderTimeSourceKind.None;

        RenderTimeChoice _choice;
        List<RenderTimeSourceKind> _changes;

        [SetUp]
        public void Begin()
        {
            _choice = new RenderTimeChoice(Gpu, Engine, Completion, Cpu);
            _changes = new List<RenderTimeSourceKind>();
        }

        // `reporting` lists the indices of the sources that report a time in each frame. Source i of the four sources reports (1 + i) ms.
        void Frames(int count, string reporting)
        {
            for (var frame = 0; frame < count; frame++)
            {
                foreach (var index in reporting) _choice.Report(index - '0', Lengths.Ms(1 + index - '0'));
                if (_choice.EndFrame()) _changes.Add(_choice.Source);
            }
        }

        [Test]
        public void EndFrame_AllSourcesReport_UsesTheBestSourceAfter30Times()
        {
            Frames(29, "0123");
            var early = _choice.Source;

            Frames(1, "0123");

            Assert.That(early, Is.EqualTo(Nothing));
            Assert.That(_choice.Source, Is.EqualTo(Gpu));
            Assert.That(_choice.RenderTime, Is.EqualTo(TimeSpan.FromMilliseconds(1)));
            Assert.That(_changes, Is.EqualTo(new[] { Gpu }));
        }

        [TestCase("13", 2, Engine)]
        [TestCase("23", 3, Completion)]
        [TestCase("3", 4, Cpu)]
        [TestCase("", 0, Nothing)]
        public void EndFrame_SomeSourcesReport_UsesTheBestReportingSource(string reporting, int expectedMs, RenderTimeSourceKind expected)
        {
            Frames(100, reporting);

            Assert.That(_choice.Source, Is.EqualTo(expected));
            Assert.That(_choice.RenderTime?.TotalMilliseconds, Is.EqualTo(expectedMs == 0 ? (double?)null : expectedMs));
        }

        [Test]
        public void EndFrame_BetterSourceStartsAFewFramesLater_WaitsForTheBetterSource()
        {
            Frames(5, "3");

            Frames(100, "23");

            Assert.That(_changes, Is.EqualTo(new[] { Completion }), "the CPU time is never used");
        }

        [Test]
        public void EndFrame_BetterSourceReportsOnce_UsesTheOtherSourceAfter30Frames()
        {
            Frames(20, "3");
            Frames(1, "03");

            Frames(29, "3");
            var waiting = _choice.Source;
            Frames(1, "3");

            Assert.That(waiting, Is.EqualTo(Nothing));
            Assert.That(_choice.Source, Is.EqualTo(Cpu));
        }

        [Test]
        public void EndFrame_BetterSourceAppears_IsUsedAfter30Times()
        {
            Frames(100, "3");
            Frames(29, "13");
            var before = _choice.Source;

            Frames(1, "13");

            Assert.That(before, Is.EqualTo(Cpu), "the old source stays in use until the better source has reported 30 times");
            Assert.That(_changes, Is.EqualTo(new[] { Cpu, Engine }));
        }

        [Test]
        public void EndFrame_SourceInUseStops_IsReplacedAfter30Frames()
        {
            Frames(100, "03");
            Frames(29, "3");
            var (before, time) = (_choice.Source, _choice.RenderTime);

            Frames(1, "3");

            Assert.That(before, Is.EqualTo(Gpu));
            Assert.That(time, Is.Null, "an old time does not replace a missing measurement");
            Assert.That(_choice.Source, Is.EqualTo(Cpu));
            Assert.That(_choice.RenderTime, Is.EqualTo(TimeSpan.FromMilliseconds(4)));
        }

        [Test]
        public void EndFrame_AllSourcesStop_ReportsNoneOnce()
        {
            Frames(100, "3");

            Frames(1000, "");

            Assert.That(_changes, Is.EqualTo(new[] { Cpu, Nothing }));
        }

        [Test]
        public void EndFrame_BetterSourceReportsIrregularly_ChangesTheSourceOnce()
        {
            for (var i = 0; i < 200; i++)
            {
                Frames(1, "03");
                Frames(i % 25, "3");
            }

            Assert.That(_changes, Is.EqualTo(new[] { Gpu }));
        }

        [Test]
        public void EndFrame_GpuTimeOfTheHeadsetStops_UsesGpuTimeOfTheEngine()
        {
            Frames(100, "01");

            Frames(100, "1");

            Assert.That(_changes, Is.EqualTo(new[] { Gpu, Engine }));
            Assert.That(_choice.RenderTime, Is.EqualTo(TimeSpan.FromMilliseconds(2)));
        }

        [TestCase(0)]
        [TestCase(-1)]
        public void Report_InvalidTime_IsIgnored(int ticks)
        {
            for (var i = 0; i < 100; i++)
            {
                _choice.Report(0, TimeSpan.FromTicks(ticks));
                _choice.EndFrame();
            }

            Assert.That(_choice.Source, Is.EqualTo(Nothing));
        }
    }
}
