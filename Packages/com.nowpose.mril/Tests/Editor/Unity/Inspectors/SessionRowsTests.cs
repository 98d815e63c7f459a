using System.Linq;
using System.Text.RegularExpressions;
using Nowpose.Editor;
using Nowpose.Session;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests
{
    public class SessionRowsTests
    {
        [Test]
        public void Rows_NothingKnown_SayDashesAndNoNumbers()
        {
            var rows = SessionRows.Of(new SessionStatistics()).ToDictionary(row => row.Label, row => row.Value);

            Assert.That(rows["Clock"], Is.EqualTo("Unsynchronised"));
            Assert.That(rows["Round trip"], Is.EqualTo("–"));
            Assert.That(rows["L_app, median (95 %)"], Is.EqualTo("– (–)"));
            Assert.That(rows["Horizon"], Is.EqualTo("–"));
            Assert.That(rows["Render time"], Is.EqualTo("–, nothing measures"));
            Assert.That(rows["Constant-latency range"], Does.StartWith("– ("));
            Assert.That(rows["Error (uncompensated)"], Is.EqualTo("– (–)"));
            Assert.That(rows["Error reduction"], Is.EqualTo("–"));
        }

        [Test]
        public void Rows_OfARunningSession_HaveValuesWithUnits()
        {
            var cell = new SimulatedSession(NetworkProfile.Wifi, seed: 3);
            cell.Run(20);
            var statistics = cell.Session.Statistics(HeadsetTime.FromSeconds(cell.Now));

            var rows = SessionRows.Of(statistics).ToDictionary(row => row.Label, row => row.Value);

            Assert.That(rows["Pose"], Is.EqualTo("Current"));
            Assert.That(rows["Clock"], Does.Match(@"^Synchronised, ± \d+\.\d\d ms$"));
            Assert.That(rows["L_visu"], Is.EqualTo("40.00 ms"));
            Assert.That(rows["L_app, median (95 %)"], Does.Match(@"^\d+\.\d\d ms \(\d+\.\d\d ms\)$"));
            Assert.That(rows["Error reduction"], Does.Match(@"^\d+ %$"));
            Assert.That(double.Parse(Regex.Match(rows["Horizon"], @"^[\d.]+").Value, System.Globalization.CultureInfo.InvariantCulture),
                Is.EqualTo(statistics.Horizon.Value.TotalMilliseconds).Within(0.006));
        }
    }
}
