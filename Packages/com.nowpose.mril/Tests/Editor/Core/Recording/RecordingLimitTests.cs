using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;
using Nowpose.Messages;
using Nowpose.Recording;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Tests.Core.Session;
using NUnit.Framework;
using static Nowpose.Tests.Core.Recording.RecordableSession;

namespace Nowpose.Tests.Core.Recording
{
    /// <summary>Tests recordings that reach a limit of the queue, the file, the disk or the settings.</summary>
    public class RecordingLimitTests
    {
        [Test]
        public void Queue_Overflow_CountsTheLostLines()
        {
            var session = NewSession();
            using (var gate = new System.Threading.ManualResetEventSlim())
            {
                var bytes = new MemoryStream();
                var recorder = new SessionRecorder(session, new RecordingSettings("slow disk", () =>
                {
                    gate.Wait();
                    return bytes;
                }));
                for (var i = 0; i < 10000; i++) session.Tick(Start + Lengths.Ms(i));
                gate.Set();
                recorder.Dispose();
                Assert.That(recorder.Ended.Wait(TimeSpan.FromMinutes(1)));

                var text = System.Text.Encoding.UTF8.GetString(bytes.ToArray());
                var lines = text.Split(new[] { '\n' }, StringSplitOptions.RemoveEmptyEntries).Select(JObject.Parse).ToList();
                var reported = lines.Where(l => (string)l["kind"] == "lost").Sum(l => (long)l["count"]);
                Assert.That(reported, Is.EqualTo(recorder.LostLines).And.GreaterThan(2000));
                Assert.That(lines.Count(l => (string)l["kind"] == "frame"), Is.GreaterThan(2000));
            }
        }

        [Test]
        public void Recorder_LinesFromSeveralThreads_KeepsEveryLineIntact()
        {
            const int count = 2000;
            var session = NewSession();
            var run = new RecordedRun(session);
            void AddExchanges()
            {
                for (var i = 1; i <= count; i++)
                {
                    session.Clock.Add(Exchange(Start + Lengths.Ms(i)), out _);
                    if (i % 500 == 0) run.Flush();
                }
            }

            var other = System.Threading.Tasks.Task.Run(AddExchanges);
            for (var i = 1; i <= count; i++)
            {
                session.Tick(Start + Lengths.Ms(i));
                if (i % 500 == 0) run.Flush();
            }
            Assert.That(other.Wait(TimeSpan.FromMinutes(2)));
            run.Close();

            Assert.That(run.Recorder.LostLines, Is.EqualTo(0));
            var expected = Enumerable.Range(1, count).Select(i => (Start + Lengths.Ms(i)).Nanoseconds).ToList();
            Assert.That(run.Of("sync").Select(l => (long)l["t4_ns"]), Is.EqualTo(expected));
            Assert.That(run.Of("frame").Select(l => (long)l["start_ns"]), Is.EqualTo(expected));
        }

        [Test]
        public void File_AtItsMaximumSize_EndsWithAWholeLineAndReportsTheLimit()
        {
            var session = NewSession();
            var run = new RecordedRun(session, maximumMegabytes: 0.02);

            for (var i = 0; i < 500; i++) session.Tick(Start + Lengths.Ms(16 * i));
            Assert.That(run.Recorder.Ended.Wait(TimeSpan.FromMinutes(1)), "the recording ends by itself");

            Assert.That(run.Recorder.State, Is.EqualTo(RecordingState.Full));
            Assert.That(run.Recorder.Problem, Does.EndWith(RecordingMessages.MaxSize("", "0.02")["recording ".Length..]));
            Assert.That(run.Text.Length, Is.EqualTo(run.Recorder.Bytes).And.LessThanOrEqualTo(20_000).And.GreaterThan(19_000));
            Assert.That((string)run.Last["reason"], Is.EqualTo("full"));
        }

        [Test]
        public void File_HeaderAboveItsMaximumSize_StartsWithTheHeader()
        {
            var session = NewSession();
            var run = new RecordedRun(session, maximumMegabytes: 0.001);

            session.Tick(Start);
            Assert.That(run.Recorder.Ended.Wait(TimeSpan.FromMinutes(1)), "the recording ends by itself");

            Assert.That(run.Recorder.State, Is.EqualTo(RecordingState.Full));
            Assert.That(run.Lines.Select(line => (string)line["kind"]), Is.EqualTo(new[] { "session", "end" }));
        }

        [Test]
        public void Disk_Fails_EndsTheRecordingButNotTheSession()
        {
            var session = NewSession();
            var recorder = new SessionRecorder(session, new RecordingSettings("disk", () => throw new IOException("No space left\non device")));
            Assert.That(recorder.Ended.Wait(TimeSpan.FromMinutes(1)));

            session.Tick(Start);
            var flush = recorder.FlushAsync();

            Assert.That(flush.Wait(TimeSpan.FromMinutes(1)), "the wait for the flush ends");
            Assert.That(recorder.State, Is.EqualTo(RecordingState.Failed));
            Assert.That(recorder.Problem, Is.EqualTo(RecordingMessages.Stopped("disk", "No space left on device")));
            recorder.Dispose();
        }

        [TestCase(0)]
        [TestCase(300)]
        [TestCase(20_000)]
        public void Disk_Full_EndsTheRecordingButNotTheSession(int room)
        {
            var simulated = new SimulatedSession(NetworkProfile.Wifi, seed: 7);
            var disk = new FullDisk(room);
            var recorder = new SessionRecorder(simulated.Session, new RecordingSettings("disk", () => disk));
            // Two seconds of lines do not fit on the disk.
            simulated.Run(2, (_, __) => { });
            Assert.That(recorder.Ended.Wait(TimeSpan.FromMinutes(1)), "the recording ends by itself");
            simulated.Run(6, (_, __) => { });
            var (bytes, lost) = (disk.ToArray(), recorder.LostLines);

            var states = new List<PoseState>();
            simulated.Run(10, (frame, _) => states.Add(frame.State));
            recorder.Dispose();

            Assert.That(states, Is.Not.Empty.And.All.EqualTo(PoseState.Current));
            Assert.That(recorder.Problem, Is.EqualTo(RecordingMessages.Stopped("disk", "No space left on device")));
            Assert.That(recorder.State, Is.EqualTo(RecordingState.Failed), "the state does not change");
            Assert.That(disk.IsClosed);
            Assert.That(disk.Refusals, Is.LessThanOrEqualTo(2), "one failed write and one failed close, without further retries");
            Assert.That(recorder.LostLines, Is.EqualTo(lost), "no lines are queued after the recording has ended");
            var text = System.Text.Encoding.UTF8.GetString(bytes);
            Assert.That(bytes.Length, Is.EqualTo(recorder.Bytes).And.LessThanOrEqualTo(room));
            var lines = text.Split(new[] { '\n' }, StringSplitOptions.RemoveEmptyEntries).Select(JObject.Parse).ToList();
            Assert.That(lines.Count, room < 1000 ? Is.EqualTo(0) : Is.GreaterThan(30), "the file contains the lines that fitted into it");
        }

        [Test]
        public void Path_NotWritable_EndsTheRecordingButNotTheSession()
        {
            // Opening a folder as a file fails for every user, including an administrator.
            var folder = Directory.CreateDirectory(Path.Combine(Path.GetTempPath(), "nowpose-" + Guid.NewGuid().ToString("N")));
            try
            {
                var simulated = new SimulatedSession(NetworkProfile.Wifi, seed: 7);
                var recorder = new SessionRecorder(simulated.Session, new RecordingSettings(folder.FullName));
                Assert.That(recorder.Ended.Wait(TimeSpan.FromMinutes(1)));

                var last = PoseState.Incomplete;
                simulated.Run(8, (frame, _) => last = frame.State);
                recorder.Dispose();

                Assert.That(last, Is.EqualTo(PoseState.Current));
                Assert.That(recorder.State, Is.EqualTo(RecordingState.Failed));
                Assert.That(recorder.Problem, Does.StartWith(RecordingMessages.Stopped(folder.FullName, "")).And.Not.Contain("\n"));
                Assert.That(recorder.LostLines, Is.EqualTo(0));
            }
            finally
            {
                folder.Delete(true);
            }
        }

        [Test]
        public void Path_FolderMissing_IsCreated()
        {
            var folder = Path.Combine(Path.GetTempPath(), "nowpose-" + Guid.NewGuid().ToString("N"));
            var path = Path.Combine(folder, "deep", "session.jsonl");
            try
            {
                var recorder = new SessionRecorder(NewSession(), new RecordingSettings(path));
                recorder.Dispose();
                Assert.That(recorder.Ended.Wait(TimeSpan.FromMinutes(1)));

                Assert.That(recorder.Problem, Is.Null);
                Assert.That(File.ReadAllLines(path), Has.Length.EqualTo(2));
            }
            finally
            {
                Directory.Delete(folder, true);
            }
        }

        [TestCase(0)]
        [TestCase(1e9)]
        [TestCase(double.NaN)]
        public void Settings_SizeOutOfRange_IsRefused(double megabytes)
        {
            Assert.Throws<InputException>(() => new RecordingSettings("x.jsonl", megabytes));
        }
    }
}
