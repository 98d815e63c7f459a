using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using System.Threading;
using Nowpose.Latency;
using Nowpose.Latency.Sweep;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency.Sweep
{
    public class SweepFileTests
    {
        string _folder;

        [SetUp]
        public void SetUp() => _folder = Path.Combine(Path.GetTempPath(), "nowpose-" + Guid.NewGuid().ToString("N"));

        [TearDown]
        public void TearDown()
        {
            if (Directory.Exists(_folder)) Directory.Delete(_folder, recursive: true);
            else File.Delete(_folder);
        }

        SweepFile NewFile() => new SweepFile(Path.Combine(_folder, "sweep.csv"), 100);

        static LoadSensitivity Finished(SweepFile file)
        {
            var closing = file.CloseAsync();
            Assert.That(closing.Wait(TimeSpan.FromTicks(30 * TimeSpan.TicksPerSecond)), "the file is closed");
            return closing.Result;
        }

        [Test]
        public void Add_AllLoads_WritesAndEvaluatesTheRows()
        {
            var sweep = new SimulatedSweep(new SweepPlan(2_000_000, 4, 1, 0), 1) { Source = RenderTimeSourceKind.DisplayGpuTime };
            var rows = sweep.Rows((t, v) => sweep.GpuMs(t, v));
            var file = NewFile();

            for (var i = 0; i < rows.Count; i++)
            {
                file.Add(rows[i]);
                if (i + 1 < rows.Count && rows[i + 1].Vertices != rows[i].Vertices) file.EndLoad();
            }
            var judged = Finished(file);

            var written = new StringWriter();
            SweepLog.WriteHeader(written);
            foreach (var row in rows) SweepLog.Write(written, row);
            Assert.That(File.ReadAllText(file.Path), Is.EqualTo(written.ToString()));
            Assert.That(judged.Words, Is.EqualTo(LoadSensitivity.Judge(rows).Words));
            Assert.That(judged.Sight, Is.EqualTo(LoadSight.Seen));
            Assert.That(file.Problem, Is.Null);
        }

        [Test]
        public void Add_BeforeTheLoadEnds_WritesFullBuffers()
        {
            var file = NewFile();

            for (var i = 0; i < 250; i++)
                file.Add(new SweepRow(ControlTime.FromSeconds(1 + i / 60.0), 0, 4, RenderTimeSourceKind.CameraCpu, "", 60));

            var written = SpinWait.SpinUntil(() => RowsIn(file.Path) == 200, TimeSpan.FromTicks(30 * TimeSpan.TicksPerSecond));
            Finished(file);
            Assert.That(written, "two buffers of 100 rows are written although no load has ended");
            Assert.That(RowsIn(file.Path), Is.EqualTo(250));
        }

        // Shares the file, because another stream may be writing to it.
        static int RowsIn(string path)
        {
            if (!File.Exists(path)) return 0;
            using (var reader = new StreamReader(new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite)))
                return reader.ReadToEnd().Count(c => c == '\n') - 1;
        }

        [Test]
        public void CloseAsync_NoRows_CreatesNoFile()
        {
            var file = NewFile();

            var judged = Finished(file);

            Assert.That(File.Exists(file.Path), Is.False);
            Assert.That(judged.Sight, Is.EqualTo(LoadSight.Unseen));
        }

        [Test]
        public void CloseAsync_FileCannotBeCreated_ReportsAProblemInOneLine()
        {
            File.WriteAllText(_folder, "a file where the folder should be");
            var file = NewFile();
            file.Add(new SweepRow(ControlTime.FromSeconds(1), 0, 4, RenderTimeSourceKind.CameraCpu, "", 60));

            var judged = Finished(file);

            Assert.That(judged, Is.Null);
            Assert.That(file.Problem, Does.Match("^" + SweepMessages.LogNotWritten(Regex.Escape(file.Path), ".+") + "$"));
        }
    }
}
