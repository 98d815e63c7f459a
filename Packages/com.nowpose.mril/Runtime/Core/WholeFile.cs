using System;
using System.IO;
using System.Text;
using System.Threading;
using Nowpose.Messages;

namespace Nowpose
{
    /// <summary>
    /// Reads and writes complete files. Writing is atomic: after a failure, the file at the path is either the complete old file or the complete new
    /// file.
    /// </summary>
    static class WholeFile
    {
        const int MaxRenamings = 10;

        static readonly TimeSpan RenamingInterval = TimeSpan.FromMilliseconds(50);

        /// <summary>Error codes of Windows for a file that another process has opened, and for the parts of a replacement that can fail.</summary>
        static readonly int[] TemporaryErrors =
        {
            unchecked((int)0x80070020), unchecked((int)0x80070497), unchecked((int)0x80070498), unchecked((int)0x80070499),
        };

        /// <param name="maxBytes">Maximum size; a larger file is rejected.</param>
        /// <exception cref="InputException">The file cannot be read; the message is one line that names it.</exception>
        public static string Read(string path, int maxBytes)
        {
            try
            {
                using var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
                // A pipe has no length.
                if (file.CanSeek && file.Length > maxBytes) throw new InputException(FileMessages.TooLong(path, file.Length, maxBytes));
                using var reader = new StreamReader(file, Encoding.UTF8);
                return reader.ReadToEnd();
            }
            catch (Exception fault) when (IsOfFiles(fault))
            {
                throw new InputException(FileMessages.NotRead(path, FirstLine(fault.Message)), fault);
            }
        }

        /// <summary>Writes a text file.</summary>
        /// <param name="path">Path of the file. Its folder is created if it does not exist.</param>
        /// <param name="what">Kind of the content, for error messages.</param>
        /// <exception cref="InputException">The file cannot be written; the old file is unchanged.</exception>
        public static void Write(string path, string text, string what)
        {
            try
            {
                var folder = Path.GetDirectoryName(Path.GetFullPath(path));
                if (!string.IsNullOrEmpty(folder)) Directory.CreateDirectory(folder);
                var bytes = Encoding.UTF8.GetBytes(text);
                Write(path, file => file.Write(bytes, 0, bytes.Length));
            }
            catch (Exception fault) when (IsOfFiles(fault))
            {
                throw new InputException(FileMessages.NotSaved(path, what, FirstLine(fault.Message)), fault);
            }
        }

        /// <summary>
        /// Writes a temporary file in the same folder, flushes it to the disk, and then gives it the name of the file. After a failure, no temporary
        /// file remains, unless the old file no longer exists.
        /// </summary>
        /// <remarks>On Windows, the method can wait for up to half a second until another process closes the file.</remarks>
        /// <param name="path">Path of the file.</param>
        /// <param name="write">Writes the content.</param>
        /// <param name="create">Creates the temporary file at a path; null to create it with the default permissions.</param>
        /// <param name="mayExist">Whether an existing file is replaced; otherwise it is kept, and the method throws.</param>
        public static void Write(string path, Action<Stream> write, Func<string, FileStream> create = null, bool mayExist = true)
        {
            var temporary = path + ".new";
            var existed = File.Exists(path);
            var file = create == null ? new FileStream(temporary, FileMode.Create, FileAccess.Write, FileShare.None) : create(temporary);
            try
            {
                using (file)
                {
                    write(file);
                    // Without the flush, the disk could receive the new name of the file before its content.
                    file.Flush(flushToDisk: true);
                }
                Rename(temporary, path, mayExist);
            }
            catch
            {
                // On Windows, a replacement that fails can remove the old file, so that the temporary file is the only copy.
                if (!existed || File.Exists(path)) Delete(temporary);
                throw;
            }
        }

        // Tries again if another program, such as a virus scanner, prevents the renaming. After error 0x498, the old file no longer exists.
        static void Rename(string temporary, string path, bool mayExist)
        {
            for (var left = MaxRenamings; ; left--)
            {
                try
                {
                    if (mayExist && File.Exists(path)) File.Replace(temporary, path, null);
                    else File.Move(temporary, path);
                    return;
                }
                catch (IOException fault) when (left > 1 && Array.IndexOf(TemporaryErrors, fault.HResult) >= 0)
                {
                    Thread.Sleep(RenamingInterval);
                }
            }
        }

        /// <summary>Returns whether a file could not be read, so that its content may still be valid, according to the fault of <see cref="Read"/>.</summary>
        public static bool IsUnread(InputException fault) => fault.InnerException != null && IsOfFiles(fault.InnerException);

        /// <summary>
        /// Renames an unusable file, so that the user can examine it. If a file with the new name already exists, it is overwritten.
        /// </summary>
        /// <returns>The new path; null if the file could not be renamed.</returns>
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

        static void Delete(string temporary)
        {
            try
            {
                File.Delete(temporary);
            }
            catch (Exception fault) when (IsOfFiles(fault))
            {
                // The failure of the writing is reported. The next writing overwrites the temporary file.
            }
        }

        static bool IsOfFiles(Exception fault) =>
            fault is IOException || fault is UnauthorizedAccessException || fault is ArgumentException || fault is NotSupportedException;

        // The messages of .NET end with a full stop, but the reason is part of a sentence.
        static string FirstLine(string message) => message.Split('\n')[0].TrimEnd().TrimEnd('.');
    }
}
