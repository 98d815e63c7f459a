using Nowpose.Latency.Profile;

namespace Nowpose.Latency
{
    /// <summary>Latency profiles in files. Whatever happens while one is saved, the file is the old or the new one, whole.</summary>
    public static class LatencyProfileFile
    {
        /// <summary>A profile has some 400 bytes; what is so much larger is something else.</summary>
        const int GreatestBytes = 64 * 1024;

        const string What = "latency profile";

        /// <exception cref="InputException">The file cannot be read, or is no profile that can be used; one line names it.</exception>
        public static LatencyProfile Load(string path) => LatencyProfileJson.Read(WholeFile.Read(path, GreatestBytes, What), path);

        /// <summary>Writes a temporary file beside it, down to the disk, and then puts it into the place of the old one.</summary>
        /// <param name="path">Its folder is made where there is none.</param>
        /// <exception cref="InputException">It cannot be written; the old file stays as it is.</exception>
        public static void Save(string path, LatencyProfile profile) => WholeFile.Write(path, LatencyProfileJson.Write(profile), What);
    }
}
