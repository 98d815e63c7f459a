using NUnit.Framework;

namespace Nowpose.Tests.Common;

/// <summary>
/// Ends a test if something is missing that it needs. The test is ignored; with the environment variable NOWPOSE_CI, which .ci/run sets, it fails,
/// so that a run without the program does not count as passed.
/// </summary>
static class Needs
{
    /// <summary>The adapters, which are built only if Node.js is installed.</summary>
    public static void Adapters() => BuiltByNode(File.Exists(Path.Combine(AppContext.BaseDirectory, "adapters", "plant.mjs")));

    /// <summary>The detection of codes in pictures, which is built only if Node.js is installed.</summary>
    public static void Vision() => BuiltByNode(File.Exists(Path.Combine(AppContext.BaseDirectory, "vision", "worker.mjs")));

    /// <param name="isBuilt">Whether a page or program exists that is built only if Node.js is installed.</param>
    public static void BuiltByNode(bool isBuilt) => Require(isBuilt, "Node.js was missing when this was built");

    /// <summary>A program of a Debian package.</summary>
    public static void Program(bool isInstalled, string package) => Require(isInstalled, $"install it: apt-get install {package}");

    static void Require(bool isThere, string missing)
    {
        if (isThere) return;
        if (Environment.GetEnvironmentVariable("NOWPOSE_CI") != null) Assert.Fail(missing);
        Assert.Ignore(missing);
    }
}
