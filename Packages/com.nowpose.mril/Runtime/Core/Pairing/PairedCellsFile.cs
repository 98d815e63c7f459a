using System.IO;
using Nowpose.Messages;

namespace Nowpose.Pairing
{
    /// <summary>
    /// Loads and saves paired cells. Saving is atomic: after a failure, the path holds either the complete old file or the complete new
    /// file.
    /// </summary>
    static class PairedCellsFile
    {
        const int MaxBytes = 1024 * 1024;

        /// <summary>Loads the cells. The list is empty if the file is missing. Renames a file that cannot be used, and reports the problem.</summary>
        /// <param name="problem">The problem in one line; null if there is none.</param>
        /// <param name="isUnread">Whether the file exists but could not be read. It may be valid, so it must not be overwritten.</param>
        public static PairedCells Load(string path, out string problem, out bool isUnread)
        {
            (problem, isUnread) = (null, false);
            if (!File.Exists(path)) return PairedCells.None;
            try
            {
                return PairedCellsJson.Read(WholeFile.Read(path, MaxBytes), path);
            }
            catch (InputException fault) when (WholeFile.IsUnread(fault))
            {
                (problem, isUnread) = (PairedCellMessages.Unread(fault.Message), true);
                return PairedCells.None;
            }
            catch (InputException fault)
            {
                var aside = WholeFile.PutAside(path);
                problem = PairedCellMessages.Lost(fault.Message, aside);
                return PairedCells.None;
            }
        }

        /// <exception cref="InputException">The file cannot be written; the old file is unchanged.</exception>
        public static void Save(string path, PairedCells cells) => WholeFile.Write(path, PairedCellsJson.Write(cells), PairedCellMessages.List);
    }
}
