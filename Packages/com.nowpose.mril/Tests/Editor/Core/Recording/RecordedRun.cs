using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;
using Nowpose.Recording;
using Nowpose.Session;

namespace Nowpose.Tests.Core.Recording
{
    /// <summary>Records a session into memory and reads the recorded lines.</summary>
    sealed class RecordedRun : IDisposable
    {
        static readonly TimeSpan Timeout = TimeSpan.FromMinutes(1);

        readonly MemoryStream _bytes = new MemoryStream();

        public RecordedRun(CompensationSession session, double maximumMegabytes = 500) => Recorder = new SessionRecorder(
            session, new RecordingSettings("memory", () => _bytes, maximumMegabytes, new DateTime(2026, 1, 2, 3, 4, 5, DateTimeKind.Utc)));

        public SessionRecorder Recorder { get; }

        /// <summary>Gets the text of the file, which is complete after the recording has ended.</summary>
        public string Text => Encoding.UTF8.GetString(_bytes.ToArray());

        public List<JObject> Lines => Text.Split(new[] { '\n' }, StringSplitOptions.RemoveEmptyEntries).Select(Read).ToList();

        public List<JObject> Of(string kind) => Lines.Where(l => (string)l["kind"] == kind).ToList();

        /// <summary>
        /// Waits until the ring buffer is written. Without this wait, a session in virtual time would fill the buffer faster than a disk can write
        /// it.
        /// </summary>
        public void Flush()
        {
            if (!Recorder.FlushAsync().Wait(Timeout)) throw new TimeoutException("the recording has not written its lines within a minute");
        }

        public RecordedRun Close()
        {
            Recorder.Dispose();
            if (!Recorder.Ended.Wait(Timeout)) throw new TimeoutException("the recording has not ended within a minute");
            return this;
        }

        public void Dispose() => Close();

        public JObject Last => Lines[Lines.Count - 1];

        // Reads integers as integers, and other numbers as the nearest double.
        static JObject Read(string line)
        {
            using (var reader = new JsonTextReader(new StringReader(line)) { DateParseHandling = DateParseHandling.None })
                return JObject.Load(reader);
        }
    }
}
