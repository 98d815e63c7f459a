using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>Reads and writes a manifest file. Writing makes a backup first, and is atomic unless the file is a symbolic link.</summary>
    sealed class ManifestFile
    {
        const int MaxSize = 1 << 20;
        const string BackupEnding = ".backup", NewEnding = ".nowpose-new";

        static readonly byte[] Bom = { 0xEF, 0xBB, 0xBF };
        static readonly UTF8Encoding Utf8 = new UTF8Encoding(encoderShouldEmitUTF8Identifier: false, throwOnInvalidBytes: true);

        readonly string _path;
        readonly byte[] _content;

        ManifestFile(string path, byte[] content)
        {
            _path = path;
            _content = content;
            Text = Decode();
        }

        /// <summary>Content of the file without a byte order mark.</summary>
        public string Text { get; }

        /// <summary>Reason why the file cannot be written, with the remedy, in one line; null if the file appears to be writable.</summary>
        public string Obstacle => IsReadOnly
            ? ManifestMessages.ReadOnly(_path)
            : null;

        bool IsLink => (File.GetAttributes(_path) & FileAttributes.ReparsePoint) != 0;

        bool IsReadOnly
        {
            get
            {
                if ((File.GetAttributes(_path) & FileAttributes.ReadOnly) != 0) return true;
                try
                {
                    // Opens the file for writing but writes nothing. Reading the attributes is not sufficient, because a link has attributes of its
                    // own.
                    using (new FileStream(_path, FileMode.Open, FileAccess.Write, FileShare.ReadWrite)) return false;
                }
                catch (UnauthorizedAccessException)
                {
                    return true;
                }
            }
        }

        bool HasBom => _content.Take(Bom.Length).SequenceEqual(Bom);

        /// <summary>Reads a manifest.</summary>
        /// <exception cref="InputException">The file is too large or is not UTF-8.</exception>
        /// <exception cref="IOException">The file cannot be read.</exception>
        /// <exception cref="UnauthorizedAccessException">Access to the file is denied.</exception>
        public static ManifestFile Read(string path)
        {
            var size = new FileInfo(path).Length;
            if (size <= MaxSize) return new ManifestFile(path, File.ReadAllBytes(path));
            throw new InputException(ManifestMessages.TooLong(path, size.ToString(CultureInfo.InvariantCulture)));
        }

        /// <summary>Replaces the content of the file.</summary>
        /// <returns>Path of the backup.</returns>
        /// <exception cref="InputException">The file is read-only, or another program has changed it since <see cref="Read"/>.</exception>
        /// <exception cref="IOException">The file cannot be written.</exception>
        /// <exception cref="UnauthorizedAccessException">Access to the file is denied.</exception>
        public string Write(string text)
        {
            if (Obstacle is string obstacle) throw new InputException(obstacle);
            if (!File.ReadAllBytes(_path).SequenceEqual(_content))
                throw new InputException(ManifestMessages.ChangedMeanwhile(_path));

            var backup = Backup();
            if (IsLink) WriteThroughLink(text, backup);
            else Replace(text);
            return backup;
        }

        void Replace(string text)
        {
            var next = _path + NewEnding;
            // Starts from a copy of the file, so that the new file has the same permissions.
            File.Copy(_path, next, overwrite: true);
            WriteTo(next, text);
            File.Replace(next, _path, null);
        }

        // Writes to the target of a link. Replacing the link itself would create a regular file and leave the target unchanged.
        void WriteThroughLink(string text, string backup)
        {
            try
            {
                WriteTo(_path, text);
            }
            catch (IOException e)
            {
                throw new InputException(ManifestMessages.NotWritten(_path, e.Message, backup), e);
            }
        }

        void WriteTo(string path, string text)
        {
            var written = Utf8.GetBytes(text);
            using (var stream = new FileStream(path, FileMode.Create, FileAccess.Write))
            {
                if (HasBom) stream.Write(Bom, 0, Bom.Length);
                stream.Write(written, 0, written.Length);
                stream.Flush(flushToDisk: true);
            }
        }

        // Copies the file to a new backup, unless there already is a backup with the same content.
        string Backup()
        {
            for (var number = 1; ; number++)
            {
                var copy = _path + BackupEnding + (number == 1 ? "" : "-" + number.ToString(CultureInfo.InvariantCulture));
                if (!File.Exists(copy)) File.Copy(_path, copy);
                if (File.ReadAllBytes(copy).SequenceEqual(_content)) return copy;
            }
        }

        string Decode()
        {
            try
            {
                var skipped = HasBom ? Bom.Length : 0;
                return Utf8.GetString(_content, skipped, _content.Length - skipped);
            }
            catch (DecoderFallbackException e)
            {
                throw new InputException(ManifestMessages.NotUtf8(_path), e);
            }
        }
    }
}
