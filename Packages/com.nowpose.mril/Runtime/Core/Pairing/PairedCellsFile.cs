using System.IO;

namespace Nowpose.Pairing
{
    /// <summary>Paired cells in a file. Whatever happens while they are saved, the file is the old or the new one, whole.</summary>
    static class PairedCellsFile
    {
        const int GreatestBytes = 1024 * 1024;
        const string What = "list of paired cells";

        /// <summary>No file is no cells. A file that cannot be used is kept beside it under another name, and said to be.</summary>
        /// <param name="problem">One line; null when nothing is wrong.</param>
        public static PairedCells Load(string path, out string problem)
        {
            problem = null;
            if (!File.Exists(path)) return PairedCells.None;
            try
            {
                return PairedCellsJson.Read(WholeFile.Read(path, GreatestBytes, What), path);
            }
            catch (InputException fault)
            {
                var aside = WholeFile.PutAside(path);
                problem = fault.Message + (aside == null ? "" : "; kept as " + aside) + "; look at the codes again";
                return PairedCells.None;
            }
        }

        /// <exception cref="InputException">It cannot be written; the old file stays as it is.</exception>
        public static void Save(string path, PairedCells cells) => WholeFile.Write(path, PairedCellsJson.Write(cells), What);
    }
}
