using System;
using System.IO;
using System.Text;

namespace Nowpose
{
    /// <summary>Small text files. Whatever happens while one is saved, the file is the old or the new one, whole.</summary>
    static class WholeFile
    {
        /// <param name="greatestBytes">What is larger is something else.</param>
        /// <param name="what">It should be, for messages.</param>
        /// <exception cref="InputException">It cannot be read; one line names it.</exception>
        public static string Read(string path, int greatestBytes, string what)
        {
            try
            {
                using var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
                if (file.Length > greatestBytes) throw new InputException(path + ": " + file.Length + " bytes are no " + what);
                using var reader = new StreamReader(file, Encoding.UTF8);
                return reader.ReadToEnd();
            }
            catch (Exception fault) when (IsOfFiles(fault))
            {
                throw new InputException(path + ": cannot be read: " + FirstLine(fault.Message), fault);
            }
        }

        /// <summary>Writes a temporary file beside it, down to the disk, and then puts it into the place of the old one.</summary>
        /// <param name="path">Its folder is made where there is none.</param>
        /// <param name="what">It is, for messages.</param>
        /// <exception cref="InputException">It cannot be written; the old file stays as it is.</exception>
        public static void Write(string path, string text, string what)
        {
            var temporary = path + ".new";
            try
            {
                var folder = Path.GetDirectoryName(Path.GetFullPath(path));
                if (!string.IsNullOrEmpty(folder)) Directory.CreateDirectory(folder);
                WriteDown(temporary, text);
                if (File.Exists(path)) File.Replace(temporary, path, null);
                else File.Move(temporary, path);
            }
            catch (Exception fault) when (IsOfFiles(fault))
            {
                throw new InputException(path + ": the " + what + " cannot be saved: " + FirstLine(fault.Message), fault);
            }
        }

        /// <summary>Renames a file that cannot be used, in place of an older one of that name: a user may want to look into it.</summary>
        /// <returns>Where it is now; null where it could not be renamed.</returns>
        public static string PutAside(string path)
        {
            var aside = path + ".bad";
            try
            {
                File.Delete(aside);
                File.Move(path, aside);
                return aside;
            }
            catch (Exception fault) when (IsOfFiles(fault))
            {
                return null;
            }
        }

        static void WriteDown(string path, string text)
        {
            var bytes = Encoding.UTF8.GetBytes(text);
            using var file = new FileStream(path, FileMode.Create, FileAccess.Write, FileShare.None);
            file.Write(bytes, 0, bytes.Length);
            // Else the name could reach the disk before what it names does.
            file.Flush(flushToDisk: true);
        }

        static bool IsOfFiles(Exception fault) =>
            fault is IOException || fault is UnauthorizedAccessException || fault is ArgumentException || fault is NotSupportedException;

        static string FirstLine(string message) => message.Split('\n')[0].TrimEnd();
    }
}
