using System;
using System.IO;

namespace Nowpose.Recording
{
    /// <summary>Where a session is recorded to, and how much of it. Immutable, checked once.</summary>
    public sealed class RecordingSettings
    {
        const int BufferBytes = 64 * 1024;

        /// <param name="path">The file; its folder is made where there is none, and a file of that name is replaced.</param>
        /// <param name="maximumMegabytes">Greatest size, 0.001 to 100 000 MB of 10⁶ bytes; then the recording ends.</param>
        /// <param name="startedUtc">Goes into the header, for whoever looks through old files; null for none.</param>
        /// <exception cref="InputException">A value is out of range, or there is no path.</exception>
        public RecordingSettings(string path, double maximumMegabytes = 500, DateTime? startedUtc = null)
            : this(path, () => OpenFile(path), maximumMegabytes, startedUtc)
        {
        }

        /// <param name="name">Stands for the path in messages.</param>
        /// <param name="open">Called once, on the recording's own thread; what it gives is disposed of there.</param>
        /// <param name="maximumMegabytes">As of the other constructor.</param>
        /// <param name="startedUtc">As of the other constructor.</param>
        /// <exception cref="InputException">A value is out of range, or there is no name.</exception>
        public RecordingSettings(string name, Func<Stream> open, double maximumMegabytes = 500, DateTime? startedUtc = null)
        {
            if (string.IsNullOrWhiteSpace(name)) throw new InputException("recording: no file is named; give the path of one");
            Path = name;
            Open = open ?? throw new ArgumentNullException(nameof(open));
            MaximumBytes = (long)(SettingRange.Require(maximumMegabytes, 0.001, 100_000, "greatest size of the recording", "MB") * 1e6);
            StartedUtc = startedUtc;
        }

        public string Path { get; }
        public long MaximumBytes { get; }
        public DateTime? StartedUtc { get; }

        internal Func<Stream> Open { get; }

        static FileStream OpenFile(string path)
        {
            var folder = System.IO.Path.GetDirectoryName(System.IO.Path.GetFullPath(path));
            if (!string.IsNullOrEmpty(folder)) Directory.CreateDirectory(folder);
            // Whoever wants to look on while it grows may.
            return new FileStream(path, FileMode.Create, FileAccess.Write, FileShare.Read, BufferBytes);
        }
    }
}
