using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Latency;
using Nowpose.Session;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    public class SessionWatchTests
    {
        // Each lower-case letter stands for one frame of 1/60 s, each capital letter for 40 frames.
        static string Run(string frames, Func<int, char, SessionChange> changed)
        {
            var letters = frames.SelectMany(c => Enumerable.Repeat(char.ToLowerInvariant(c), char.IsUpper(c) ? 40 : 1));
            return string.Join(" ", letters.Select((letter, i) => changed(i, letter)).Where(c => c != SessionChange.None));
        }

        static HeadsetTime At(int frame) => HeadsetTime.FromSeconds(100 + frame / 60.0);

        // Poses: . incomplete, u unsynchronised, h held, o outside range, c current.
        static string PoseChanges(SessionWatch watch, string frames) => Run(frames, (frame, letter) =>
        {
            var pose = (PoseState)".uhoc".IndexOf(letter);
            return watch.Changed(At(frame), pose, pose > PoseState.Unsynchronised, RangeState.Unknown);
        });

        [TestCase("UU", "", TestName = "Changed_NeverSynchronised_IsNotLost")]
        [TestCase("UC", "Synchronised", TestName = "Changed_ClockSettled_IsSynchronised")]
        [TestCase("Ucccu", "", TestName = "Changed_SynchronisedForThreeFrames_ReportsNothing")]
        [TestCase("UCuuu", "Synchronised Lost", TestName = "Changed_NoLongerSynchronised_IsLostImmediately")]
        [TestCase("UCuccuccucuuC", "Synchronised Lost Synchronised", TestName = "Changed_ClockFlickers_IsLostOnce")]
        [TestCase("UHC", "Synchronised", TestName = "Changed_HeldBeforeEverPredicted_IsNotStale")]
        [TestCase("UCHHC", "Synchronised Stale", TestName = "Changed_SamplesStop_IsStaleOnce")]
        [TestCase("UCHCH", "Synchronised Stale Stale", TestName = "Changed_SamplesStopAgain_IsStaleAgain")]
        [TestCase("UChchcchchh", "Synchronised Stale", TestName = "Changed_SamplesFlicker_IsStaleOnce")]
        [TestCase("UOH", "Synchronised Stale", TestName = "Changed_OutsideRangeThenHeld_IsStaleOnlyWhenHeld")]
        [TestCase("UCUH", "Synchronised Lost Stale Synchronised", TestName = "Changed_HeldAfterLost_IsStaleAsSoonAsItsAgeIsKnown")]
        public void Changed_Poses_ReportsTheExpectedChanges(string frames, string expected)
        {
            Assert.That(PoseChanges(new SessionWatch(), frames), Is.EqualTo(expected));
        }

        // Ranges: u unknown, i inside, o outside because of the render time, m outside because frames miss refreshes.
        [TestCase("uu", "", TestName = "Changed_RangeUnknown_ReportsNothing")]
        [TestCase("uI", "EnteredRange", TestName = "Changed_InsideForHalfASecond_ReportsEnteredRange")]
        [TestCase("uo", "LeftRange", TestName = "Changed_OutsideFromTheStart_ReportsLeftRange")]
        [TestCase("IoOII", "EnteredRange LeftRange EnteredRange", TestName = "Changed_LoadComesAndGoes_ReportsEachChangeOfRange")]
        [TestCase("Ioioiiiooi", "EnteredRange LeftRange", TestName = "Changed_RangeFlickers_ReportsLeftRangeOnce")]
        [TestCase("IuuuI", "EnteredRange", TestName = "Changed_RangeTemporarilyUnknown_ReportsNothing")]
        [TestCase("OuiiiiuiiiiuiiiiU", "LeftRange", TestName = "Changed_RangeRepeatedlyUnknown_ReportsNoReturn")]
        [TestCase("UMUMU", "LeftRange EnteredRange LeftRange EnteredRange", TestName = "Changed_FramesMissRefreshesTwice_ReportsBothEpisodes")]
        [TestCase("IMIMU", "EnteredRange LeftRange EnteredRange LeftRange EnteredRange",
            TestName = "Changed_FramesMissRefreshesInRange_ReportsEachChange")]
        [TestCase("UMumuuumumm", "LeftRange", TestName = "Changed_MissedRefreshesFlicker_ReportsLeftRangeOnce")]
        [TestCase("MOU", "LeftRange", TestName = "Changed_RenderTimeBeyondTheLimitAfterMissedRefreshes_ReportsNoReturn")]
        public void Changed_Ranges_ReportsTheExpectedChanges(string frames, string expected)
        {
            var watch = new SessionWatch();

            var changes = Run(frames, (frame, letter) =>
            {
                var range = letter == 'm' ? RangeState.Outside : (RangeState)"uio".IndexOf(letter);
                return watch.Changed(At(frame), PoseState.Incomplete, false, range, missesRefreshes: letter == 'm');
            });

            Assert.That(changes, Is.EqualTo(expected));
        }

        [Test]
        public void Changed_Synchronised_IsReportedAfterHalfASecond()
        {
            var watch = new SessionWatch();

            var changes = Enumerable.Range(0, 60).Select(i => watch.Changed(At(i), PoseState.Current, true, RangeState.Unknown)).ToList();

            Assert.That(changes.IndexOf(SessionChange.Synchronised), Is.EqualTo(30));
        }

        [Test]
        public void Changed_SeveralChanges_AreAllReported()
        {
            var watch = new SessionWatch();
            for (var frame = 0; frame < 40; frame++) watch.Changed(At(frame), PoseState.Current, true, RangeState.Inside);

            var change = watch.Changed(At(40), PoseState.Held, false, RangeState.Outside);

            Assert.That(change, Is.EqualTo(SessionChange.Lost | SessionChange.LeftRange | SessionChange.Stale));
        }

        [Test]
        public void End_Synchronised_ReportsLostAndResets()
        {
            var watch = new SessionWatch();
            var before = watch.End();
            PoseChanges(watch, "C");

            var after = watch.End();

            Assert.That(before, Is.EqualTo(SessionChange.None));
            Assert.That(after, Is.EqualTo(SessionChange.Lost));
            Assert.That(PoseChanges(watch, "UHC"), Is.EqualTo("Synchronised"), "after the reset, the held pose is not reported as stale");
        }

        [Test]
        public void Changed_WholeSession_ReportsAllChangesInOrder()
        {
            var simulated = new SimulatedSession(NetworkProfile.Wifi, 7);
            var watch = new SessionWatch();
            var changes = new List<SessionChange>();
            void Run(double seconds) => simulated.Run(seconds, (frame, light) =>
            {
                var change = watch.Changed(frame);
                if (change != SessionChange.None) changes.Add(change);
            });

            Run(10);
            simulated.IsGatewayUp = false;
            Run(3);
            simulated.IsGatewayUp = true;
            Run(5);
            simulated.Link.Step = TimeSpan.FromSeconds(60);
            Run(10);

            Assert.That(changes.First(), Is.EqualTo(SessionChange.Synchronised));
            Assert.That(changes[1], Is.EqualTo(SessionChange.Stale));
            Assert.That(changes.Skip(2), Has.Member(SessionChange.Lost).And.Member(SessionChange.Synchronised));
            Assert.That(changes.Count, Is.LessThan(8), string.Join(" ", changes));
        }
    }
}
