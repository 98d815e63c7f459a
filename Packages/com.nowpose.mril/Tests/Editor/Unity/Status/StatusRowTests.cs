using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Messages;
using Nowpose.Session;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Status;
using NUnit.Framework;
using static Nowpose.Tests.Unity.Status.StatusRows;

namespace Nowpose.Tests.Unity.Status
{
    public class StatusRowTests
    {
        [Test]
        public void Update_WithoutStatistics_ShowsDashesAndNoRowForObjects()
        {
            var texts = new StatusTexts();

            texts.Update(null, null, null, null);

            for (var row = StatusRow.Pose; row < StatusRow.Message; row++)
            {
                Assert.That(texts.ValueOf(row), Is.EqualTo(row >= StatusRow.Objects ? "" : "–"), row.ToString());
                Assert.That(texts.NoteOf(row), Is.Empty, row.ToString());
            }
            Assert.That(texts.IsShown(StatusRow.Objects), Is.False, "a cell without objects has no row for objects");
            Assert.That(texts.ValueOf(StatusRow.Message), Is.Empty);
        }

        [TestCase(1)]
        [TestCase(6)]
        [TestCase(20)]
        public void Update_PartsNotCurrent_HaveARowEachAndTheLastRowStatesTheRest(int count)
        {
            var parts = new ShownParts();
            for (var i = 0; i < count; i++) parts.Add(new Part("object box_" + i));
            var texts = new StatusTexts();

            texts.Update(new SessionStatistics { SettledPose = PoseState.Held }, Loopback, "test", null, parts: parts);

            var rows = Enumerable.Range((int)StatusRow.FirstPart, 6).Select(row => (StatusRow)row).ToArray();
            var named = count <= 6 ? count : 5;
            Assert.That(rows.Take(named).Select(texts.ValueOf), Is.EqualTo(Enumerable.Range(0, named).Select(i => "! object box_" + i)));
            Assert.That(rows.Take(named).Select(texts.NoteOf), Is.All.EqualTo(FrameMessages.PosesStopped));
            Assert.That(texts.ValueOf(StatusRow.LastPart), Is.EqualTo(count < 6 ? "" : count == 6 ? "! object box_5" : "! and 15 more"));
            Assert.That(rows.Count(texts.IsShown), Is.EqualTo(Math.Min(6, count)));
        }

        [Test]
        public void Update_MorePartsNotCurrentThanRows_NamesThoseWithoutDataAndThenThoseThatFailedLast()
        {
            var parts = new ShownParts();
            for (var i = 0; i < 8; i++) parts.Add(new Part("object box_" + i) { FaultSince = i == 6 ? (ControlTime?)null : ControlTime.FromSeconds(1000 + i) });
            var texts = new StatusTexts();

            texts.Update(new SessionStatistics { SettledPose = PoseState.Current }, Loopback, "test", null, parts: parts);

            var rows = Enumerable.Range((int)StatusRow.FirstPart, 6).Select(row => texts.ValueOf((StatusRow)row));
            Assert.That(rows, Is.EqualTo(new[] { 6, 7, 5, 4, 3 }.Select(i => "! object box_" + i).Append("! and 3 more")));
        }

        [Test]
        public void Update_LongMessage_LeavesFewerRowsForParts()
        {
            var parts = new ShownParts();
            for (var i = 0; i < 20; i++) parts.Add(new Part("object box_" + i));
            var texts = new StatusTexts();
            var shown = new List<int>();
            for (var words = 0; words < 200; words += 5)
            {
                texts.Update(new SessionStatistics { SettledPose = PoseState.Current }, Loopback, "test", Words(words), parts: parts);
                var rows = Enumerable.Range((int)StatusRow.FirstPart, 6).Count(row => texts.IsShown((StatusRow)row));
                Assert.That(rows, Is.EqualTo(Math.Min(6, Math.Max(0, 7 - texts.MessageLines))), texts.MessageLines + " lines");
                if (rows > 0) Assert.That(texts.ValueOf(StatusRow.FirstPart + rows - 1), Is.EqualTo("! and " + (21 - rows) + " more"));
                shown.Add(rows);
            }
            Assert.That(shown.Distinct(), Is.EquivalentTo(Enumerable.Range(0, 7)));
        }

        [TestCase(PoseState.Unsynchronised)]
        [TestCase(PoseState.OutsideRange)]
        [TestCase(PoseState.Current)]
        public void Update_CommonFault_HasNoRowButFaultsOfTheirOwnHave(PoseState pose)
        {
            var parts = new ShownParts();
            parts.Add(new Part("object box") { IsFaultCommon = true });
            parts.Add(new Part("object lid"));
            var texts = new StatusTexts();

            texts.Update(new SessionStatistics { SettledPose = pose }, Loopback, "test", null, parts: parts);

            Assert.That(texts.ValueOf(StatusRow.Objects), Is.EqualTo(StatusMessages.NotCurrent(2)));
            Assert.That(texts.ValueOf(StatusRow.FirstPart), Is.EqualTo("! object lid"));
            Assert.That(texts.IsShown(StatusRow.SecondPart), Is.False);
        }

        [Test]
        public void Update_PartNotCurrent_TheLabelIsTheTimeSinceWhen()
        {
            var parts = new ShownParts();
            parts.Add(new Part("object box") { FaultSince = ControlTime.FromSeconds(1000) });
            parts.Add(new Part("object lid"));
            var now = new DateTime(2026, 3, 5, 14, 3, 20);
            var texts = new StatusTexts(() => now);
            string Label(double seconds, StatusRow row = StatusRow.SecondPart)
            {
                texts.Update(new SessionStatistics { Now = ControlTime.FromSeconds(seconds) }, Loopback, "test", null, parts: parts);
                return texts.LabelOf(row);
            }

            var label = Label(1008);
            Assert.That((label, Label(1008, StatusRow.FirstPart), Label(1008, StatusRow.ThirdPart)), Is.EqualTo(("since 14:03:12", "", "")));
            now = now.AddSeconds(600.4);
            Assert.That(Label(1608), Is.SameAs(label), "the two clocks are not read at the same moment");
            now = now.AddDays(1);
            Assert.That(Label(1608 + 86400), Is.EqualTo(StatusMessages.Since("Mar 5")));
            texts.Update(new SessionStatistics(), Loopback, "test", null, parts: parts);
            Assert.That(texts.LabelOf(StatusRow.SecondPart), Is.Empty, "the control time is not known");
        }

        [Test]
        public void Update_MovingBaseNotCurrent_StatesItAsTheReason()
        {
            var texts = new StatusTexts();

            texts.Update(new SessionStatistics { SettledPose = PoseState.Held, IsSettledLimitedByBase = true }, Loopback, "test", null);

            Assert.That((texts.ValueOf(StatusRow.Pose), texts.NoteOf(StatusRow.Pose)), Is.EqualTo(("! held", StatusMessages.BaseNotCurrent)));
        }

        sealed class Part : IShownPart
        {
            public Part(string title) => Title = title;

            public string Title { get; }
            public string Fault => FrameMessages.PosesStopped;
            public bool IsFaultCommon { get; set; }
            public ControlTime? FaultSince { get; set; }
        }
    }
}
