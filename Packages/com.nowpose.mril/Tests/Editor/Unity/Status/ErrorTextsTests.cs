using System;
using Nowpose.Messages;
using Nowpose.Session;
using Nowpose.Session.Hindcast;
using Nowpose.Unity.Status;
using NUnit.Framework;
using static Nowpose.Tests.Unity.Status.StatusRows;

namespace Nowpose.Tests.Unity.Status
{
    /// <summary>Tests the rows that show the displayed error and its reduction.</summary>
    public class ErrorTextsTests
    {
        static DisplayedError Error(double rms, double p95, double? reduction, double? uncertainty) =>
            new DisplayedError(600, rms, p95, 30, 60, reduction, uncertainty, 0.2, 0.1);

        [TestCase(0.874, 0.021, "87 %|± 2 %")]
        [TestCase(-0.12, 0.3, "−12 %|± 30 %")]
        [TestCase(0.874, null, "87 %|")]
        public void Update_Reduction_HasItsUncertaintyOnceKnown(double reduction, double? uncertainty, string expected)
        {
            Assert.That(Row(StatusRow.Reduction, new SessionStatistics { ToolError = Error(3, 8, reduction, uncertainty) }), Is.EqualTo(expected));
        }

        [TestCase(ErrorWithheldReason.None, "–|")]
        [TestCase(ErrorWithheldReason.OutsideRange, "–|outside range")]
        [TestCase(ErrorWithheldReason.BeyondMeasured, "–|" + StateNames.BeyondMeasured)]
        [TestCase(ErrorWithheldReason.OtherSource, "–|" + StateNames.OtherSourceLimit)]
        [TestCase(ErrorWithheldReason.NoRenderTime, "–|" + StateNames.RenderTimeNotMeasured)]
        [TestCase(ErrorWithheldReason.LowFrameRate, "–|" + StateNames.FramesMissRefreshes)]
        [TestCase(ErrorWithheldReason.LongerThanRefresh, "–|" + StateNames.FramesMissRefreshes)]
        [TestCase(ErrorWithheldReason.MovingBase, "–|" + StateNames.MovingBase)]
        public void Update_ErrorIsWithheld_ShowsTheReasonBesideTheMissingError(object reason, string expected)
        {
            var statistics = new SessionStatistics { ErrorWithheld = (ErrorWithheldReason)reason };

            Assert.That((Row(StatusRow.Reduction, statistics), Row(StatusRow.Error, statistics)), Is.EqualTo((expected, expected)));
        }

        [Test]
        public void Update_Error_ShowsTheErrorWithCompensation()
        {
            Assert.That(Row(StatusRow.Error, new SessionStatistics { ToolError = Error(3.24, 8.17, 0.9, 0.01) }), Is.EqualTo("3.2 mm|95 % below 8.2 mm"));
        }

        [Test]
        public void Update_RobotAtRest_ShowsAnErrorButNoReduction()
        {
            var statistics = new SessionStatistics { ToolError = Error(0, 0, null, null) };

            Assert.That(Row(StatusRow.Reduction, statistics), Is.EqualTo("–|"));
            Assert.That(Row(StatusRow.Error, statistics), Is.EqualTo("0.0 mm|95 % below 0.0 mm"));
        }

        [Test]
        public void JointErrorLine_SameNumbers_ReusesTheText()
        {
            var line = new JointErrorLine();
            JointError[] Joints(double? reduction) => new[]
            {
                new JointError("shoulder", Error(0.01, 0.02, reduction, null)), new JointError("elbow", null),
            };

            var text = line.Of(Joints(0.912));

            Assert.That(text, Is.EqualTo("shoulder 91 %, elbow –"));
            Assert.That(line.Of(Joints(0.914)), Is.SameAs(text));
            Assert.That(line.Of(Joints(0.87)), Is.EqualTo("shoulder 87 %, elbow –"));
            Assert.That(line.Of(Array.Empty<JointError>()), Is.Empty);
        }
    }
}
