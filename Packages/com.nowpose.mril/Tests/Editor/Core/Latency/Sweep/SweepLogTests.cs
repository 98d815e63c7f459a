using System;
using System.IO;
using System.Linq;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Sweep;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency.Sweep
{
    public class SweepLogTests
    {
        const string Header = "control_ns,vertices,render_ms,source,device,display_hz\n";

        static string Text(params SweepRow[] rows)
        {
            var text = new StringWriter();
            SweepLog.WriteHeader(text);
            foreach (var row in rows) SweepLog.Write(text, row);
            return text.ToString();
        }

        static SweepRow[] Read(string text) => SweepLogReader.Read(new StringReader(text), "sweep.csv").ToArray();

        static SweepRow Row(
            double? renderMs = 7.25, RenderTimeSourceKind source = RenderTimeSourceKind.DisplayGpuTime, string device = "HoloLens 2") =>
            new SweepRow(ControlTime.FromNanoseconds(1_700_000_000_123_456_700), 300_000, renderMs, source, device, 60);

        [Test]
        public void Row_Written_HasTheDocumentedFormat()
        {
            Assert.That(Text(Row()), Is.EqualTo(Header + "1700000000123456700,300000,7.25,display_gpu_time,HoloLens 2,60\n"));
        }

        [TestCase(RenderTimeSourceKind.None, null, "HoloLens 2")]
        [TestCase(RenderTimeSourceKind.GpuCompletion, null, "HoloLens 2")]
        [TestCase(RenderTimeSourceKind.CameraCpu, 0.6251, "")]
        [TestCase(RenderTimeSourceKind.EngineGpuTime, 16.6667, "PC \"lab\", left")]
        public void Row_Written_RoundTrips(RenderTimeSourceKind source, double? renderMs, string device)
        {
            var row = Row(renderMs, source, device);

            var read = Read(Text(row, row));

            Assert.That(read, Has.Length.EqualTo(2));
            Assert.That(read[1].FrameStart, Is.EqualTo(row.FrameStart));
            Assert.That(read[1].Vertices, Is.EqualTo(300_000));
            Assert.That(read[1].RenderMs, Is.EqualTo(renderMs));
            Assert.That(read[1].Source, Is.EqualTo(source));
            Assert.That(read[1].Device, Is.EqualTo(device));
            Assert.That(read[1].DisplayHz, Is.EqualTo(60));
        }

        static readonly DisplayConditions Conditions = new DisplayConditions(
            "HoloLens 2", 60, "Direct3D11", "MultiThreaded", "built-in", false, "PrioritizeRendering", ReprojectionMode.Depth);

        [Test]
        public void Conditions_Written_AreReadExceptRowValues()
        {
            var text = new StringWriter();
            SweepLog.WriteHeader(text, Conditions);
            SweepLog.Write(text, Row());

            var rows = SweepLogReader.Read(new StringReader(text.ToString()), "sweep.csv", out var conditions);

            Assert.That(text.ToString(), Does.StartWith("# graphics_api: Direct3D11\n# graphics_jobs: MultiThreaded\n"));
            Assert.That(rows, Has.Count.EqualTo(1));
            Assert.That(conditions, Is.EqualTo(new DisplayConditions().Or(new DisplayConditions(
                null, null, "Direct3D11", "MultiThreaded", "built-in", false, "PrioritizeRendering", ReprojectionMode.Depth))));
        }

        [Test]
        public void Conditions_LogOfAnOlderVersion_AreUnknown()
        {
            SweepLogReader.Read(new StringReader(Text(Row())), "sweep.csv", out var conditions);

            Assert.That(conditions, Is.EqualTo(DisplayConditions.Unknown));
        }

        [Test]
        public void Conditions_FieldsOfANewerVersion_AreIgnored()
        {
            var read = Read("# future: 5\n# a remark\n" + Text(Row()));

            Assert.That(read, Has.Length.EqualTo(1));
        }

        [TestCase("# reprojection: sideways\n", "sweep.csv: reprojection: 'sideways' is not allowed")]
        [TestCase("# graphics_api: Vulkan\nother\n", "sweep.csv:2: the header is 'other'")]
        public void Conditions_Invalid_AreRefused(string text, string message)
        {
            Assert.That(() => Read(text + Header), Throws.TypeOf<InputException>().With.Message.StartsWith(message));
        }

        [Test]
        public void Text_OtherLineEndsAndUnknownDisplayRate_IsRead()
        {
            var read = Read(Header.Replace("\n", "\r\n") + "5,0,,,,\r\n\r\n");

            Assert.That(read.Single().DisplayHz, Is.NaN);
        }

        [TestCase("", "sweep.csv:1: the header is ''")]
        [TestCase("time,load\n1,2\n", "sweep.csv:1: the header is 'time,load'; it must be control_ns,")]
        [TestCase(Header, "sweep.csv: there are no rows below the header")]
        [TestCase(Header + "5,0,4,display_gpu_time,x\n", "sweep.csv:2: 5 fields; it must have 6")]
        [TestCase(Header + "5.5,0,4,display_gpu_time,x,60\n", "sweep.csv:2: control_ns: '5.5' is not a whole number of nanoseconds")]
        [TestCase(
            Header + "5,0,,,x,60\n5,2000001,4,display_gpu_time,x,60\n", "sweep.csv:3: vertices: 2000001 is out of range; allowed are 0 to 2000000")]
        [TestCase(Header + "5,0,0,display_gpu_time,x,60\n", "sweep.csv:2: render_ms: 0 ms is out of range; allowed are 0.001 to 1000 ms")]
        [TestCase(Header + "5,0,NaN,display_gpu_time,x,60\n", "sweep.csv:2: render_ms: NaN ms is out of range; allowed are 0.001 to 1000 ms")]
        [TestCase(Header + "5,0,-1,display_gpu_time,x,60\n", "sweep.csv:2: render_ms: -1 ms is out of range")]
        [TestCase(Header + "5,0,1001,display_gpu_time,x,60\n", "sweep.csv:2: render_ms: 1001 ms is out of range")]
        [TestCase(Header + "5,0,4 ms,display_gpu_time,x,60\n", "sweep.csv:2: render_ms: '4 ms' is not a number of milliseconds")]
        [TestCase(Header + "5,0,4,gpu,x,60\n", "sweep.csv:2: source: 'gpu' is not a source of render times; allowed are display_gpu_time, ")]
        [TestCase(Header + "5,0,4,,x,60\n", "sweep.csv:2: render_ms: its source is missing")]
        [TestCase(Header + "5,0,4,camera_cpu,x,0\n", "sweep.csv:2: display rate: 0 Hz is out of range")]
        public void Text_Invalid_IsRefusedInOneLineWithItsPlace(string text, string message)
        {
            var fault = Assert.Throws<InputException>(() => Read(text));

            Assert.That(fault.Message, Does.StartWith(message));
            Assert.That(fault.Message, Does.Not.Contain("\n"));
        }

        [Test]
        public void File_Missing_ThrowsWithTheName()
        {
            var path = Path.Combine(Path.GetTempPath(), "nowpose-" + Guid.NewGuid().ToString("N") + ".csv");

            Assert.That(() => SweepLogReader.Read(path), Throws.TypeOf<InputException>().With.Message.StartsWith(path + ": cannot be read"));
        }
    }
}
