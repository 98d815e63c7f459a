using Nowpose.Latency.Profile;

namespace Nowpose.Latency
{
    /// <summary>Reads and writes latency profiles in files. A failed save leaves the old file intact.</summary>
    public static class LatencyProfileFile
    {
        /// <summary>Maximum file size. A profile has about 400 bytes, so a much larger file is not a profile.</summary>
        const int MaxBytes = 64 * 1024;

        const string What = "latency profile";

        /// <exception cref="InputException">The file cannot be read or is not a usable profile; the message names it in one line.</exception>
        public static LatencyProfile Load(string path) => LatencyProfileJson.Read(WholeFile.Read(path, MaxBytes), path);

        /// <summary>Writes a temporary file in the same folder, flushes it to the disk, and then replaces the old file with it.</summary>
        /// <param name="path">Path of the file. Its folder is created if it does not exist.</param>
        /// <exception cref="InputException">The file cannot be written; the old file is unchanged.</exception>
        public static void Save(string path, LatencyProfile profile) => WholeFile.Write(path, LatencyProfileJson.Write(profile), What);
    }
}
