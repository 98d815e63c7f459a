using System;
using System.IO;
using System.Text;

namespace Nowpose.Latency
{
    /// <summary>Latency profiles in files. Whatever happens while one is saved, the file is the old or the new one, whole.</summary>
    public static class LatencyProfileFile
    {
        /// <summary>A profile has some 400 bytes; what is so much larger is something else.</summary>
        const int GreatestBytes = 64 * 1024;

        /// <exception cref="InputException">The file cannot be read, or is no profile that can be used; one line names it.</exception>
        public static LatencyProfile Load(string path)
        {
            try
            {
                return LatencyProfileJson.Read(ReadText(path), path);
            }
            catch (Exception fault) when (fault is IOException || fault is UnauthorizedAccessException || IsBadPath(fault))
            {
                throw new InputException(path + ": cannot be read: " + FirstLine(fault.Message), fault);
            }
        }

        /// <summary>Writes a temporary file beside it, down to the disk, and then puts it into the place of the old one.</summary>
        /// <param name="path">Its folder is made where there is none.</param>
        /// <exception cref="InputException">It cannot be written; the old file stays as it is.</exception>
        public static void Save(string path, LatencyProfile profile)
        {
            var temporary = path + ".new";
            try
            {
                var folder = Path.GetDirectoryName(Path.GetFullPath(path));
                if (!string.IsNullOrEmpty(folder)) Directory.CreateDirectory(folder);
                WriteText(temporary, LatencyProfileJson.Write(profile));
                if (File.Exists(path)) File.Replace(temporary, path, null);
                else File.Move(temporary, path);
            }
            catch (Exception fault) when (fault is IOException || fault is UnauthorizedAccessException || IsBadPath(fault))
            {
                throw new InputException(path + ": the latency profile cannot be saved: " + FirstLine(fault.Message), fault);
            }
        }

        static string ReadText(string path)
        {
            using var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
            if (file.Length > GreatestBytes) throw new InputException(path + ": " + file.Length + " bytes are no latency profile");
            using var reader = new StreamReader(file, Encoding.UTF8);
            return reader.ReadToEnd();
        }

        static void WriteText(string path, string text)
        {
            var bytes = Encoding.UTF8.GetBytes(text);
            using var file = new FileStream(path, FileMode.Create, FileAccess.Write, FileShare.None);
            file.Write(bytes, 0, bytes.Length);
            // Else the name could reach the disk before what it names does.
            file.Flush(flushToDisk: true);
        }

        static bool IsBadPath(Exception fault) => fault is ArgumentException || fault is NotSupportedException;

        static string FirstLine(string message) => message.Split('\n')[0].TrimEnd();
    }
}
