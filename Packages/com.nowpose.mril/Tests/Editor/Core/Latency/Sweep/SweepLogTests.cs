using System.IO;
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

        static SweepRow Row(
            double? renderMs = 7.25, RenderTimeSourceKind source = RenderTimeSourceKind.DisplayGpuTime, string device = "HoloLens 2") =>
            new SweepRow(ControlTime.FromNanoseconds(1_700_000_000_123_456_700), 300_000, renderMs, source, device, 60);

        [Test]
        public void Row_Written_HasTheDocumentedFormat()
        {
            Assert.That(Text(Row()), Is.EqualTo(Header + "1700000000123456700,300000,7.25,display_gpu_time,HoloLens 2,60\n"));
        }

        [TestCase(RenderTimeSourceKind.None, null, "HoloLens 2", ",,HoloLens 2")]
        [TestCase(RenderTimeSourceKind.GpuCompletion, null, "HoloLens 2", ",gpu_completion,HoloLens 2")]
        [TestCase(RenderTimeSourceKind.CameraCpu, 0.62514, "", "0.6251,camera_cpu,")]
        [TestCase(RenderTimeSourceKind.EngineGpuTime, 16.6667, "PC \"lab\", left\n", "16.6667,engine_gpu_time,\"PC \"\"lab\"\", left \"")]
        public void Row_UnknownValuesAndSpecialCharacters_AreWrittenInOneLine(
            RenderTimeSourceKind source, double? renderMs, string device, string expected)
        {
            Assert.That(Text(Row(renderMs, source, device)), Is.EqualTo(Header + "1700000000123456700,300000," + expected + ",60\n"));
        }

        static readonly DisplayConditions Conditions = new DisplayConditions(
            "HoloLens 2", 60, "Direct3D11", "MultiThreaded", "built-in", false, "PrioritizeRendering", ReprojectionMode.Depth);

        [Test]
        public void Conditions_Written_PrecedeTheHeaderAndOmitValuesOfTheRows()
        {
            var text = new StringWriter();
            SweepLog.WriteHeader(text, Conditions);

            Assert.That(text.ToString(), Does.StartWith("# graphics_api: Direct3D11\n# graphics_jobs: MultiThreaded\n"));
            Assert.That(text.ToString(), Does.EndWith("\n" + Header).And.Not.Contain("HoloLens"));
        }
    }
}
