using System.Linq;
using System.Text.RegularExpressions;
using Nowpose.Editor;
using Nowpose.Editor.Inspectors;
using Nowpose.Editor.Messages;
using Nowpose.Latency;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Tests.Core;
using Nowpose.Tests.Core.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Unity.Inspectors
{
    public class SessionRowsTests
    {
        [Test]
        public void Rows_UnknownValues_AreDashes()
        {
            var rows = SessionRows.Of(new SessionStatistics()).ToDictionary(row => row.Label, row => row.Value);

            Assert.That(rows["Round trip"], Is.EqualTo("–"));
            Assert.That(rows["End to end"], Is.EqualTo("–"));
            Assert.That(rows["Error, uncompensated"], Is.EqualTo("–, –"));
            Assert.That(rows["Clock sync"], Is.EqualTo("not connected"));
        }

        [TestCase(false, false, "as calibrated")]
        [TestCase(true, false, InspectorTexts.Predicted)]
        [TestCase(false, true, "implausible, 8123.40 ms ahead")]
        public void Rows_DisplayTime_NameItsSource(bool isPredicted, bool isImplausible, string expected)
        {
            var statistics = new SessionStatistics
            {
                IsLightPredicted = isPredicted, IsDisplayTimeImplausible = isImplausible, DisplayTimeAhead = Lengths.Ms(8123.4),
            };

            var rows = SessionRows.Of(statistics).ToDictionary(row => row.Label, row => row.Value);

            Assert.That(rows["Display time"], Is.EqualTo(expected));
        }

        [Test]
        public void Rows_Reprojection_NameModeAndDepth()
        {
            var statistics = new SessionStatistics { Reprojection = ReprojectionMode.PlanarManual, DepthSubmission = DepthSubmission.TurnedOff };

            var rows = SessionRows.Of(statistics).ToDictionary(row => row.Label, row => row.Value);

            Assert.That(rows["Reprojection, depth"], Is.EqualTo("planar manual, turned off"));
        }

        [Test]
        public void Rows_RunningSession_HaveValuesWithUnits()
        {
            var cell = new SimulatedSession(NetworkProfile.Wifi, seed: 3);
            cell.Run(20);
            var statistics = cell.Session.Statistics(HeadsetTime.FromSeconds(cell.Now));

            var rows = SessionRows.Of(statistics).ToDictionary(row => row.Label, row => row.Value);

            Assert.That(rows["Round trip"], Does.Match(@"^\d+\.\d\d ms$"));
            Assert.That(rows["Error, uncompensated"], Does.Match(@"^\d+\.\d\d mm, \d+\.\d\d mm$"));
            Assert.That(rows["Samples, dropped"], Does.Match(@"^[1-9]\d*, \d+$"));
            Assert.That(double.Parse(Regex.Match(rows["End to end"], @"^[\d.]+").Value, System.Globalization.CultureInfo.InvariantCulture),
                Is.EqualTo(statistics.EndToEndLatency.Value.TotalMilliseconds).Within(0.006));
        }
    }
}
