using System.Diagnostics;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Shaders;

/// <summary>Compiles programs with glslangValidator (Debian's package glslang-tools).</summary>
static class Glslang
{
    const string Tool = "glslangValidator";

    /// <summary>Ignores the test if the compiler is not installed. In CI, the test fails instead.</summary>
    public static void Require()
    {
        var folders = (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator);
        Needs.Program(folders.Any(folder => File.Exists(Path.Combine(folder, Tool))), "glslang-tools");
    }

    /// <summary>Compiles both stages of every variant of a program.</summary>
    /// <returns>
    /// The errors, each with shader, pipeline, pass, variant, stage and line; empty if all variants compile. The variants are compiled while the
    /// errors are enumerated.
    /// </returns>
    public static IEnumerable<string> Compile(PassProgram program)
    {
        using var folder = new TemporaryFolder();
        // Adds empty lines before the program, so that line numbers are the same as in the shader's file.
        var file = Path.GetFileName(program.Shader.Path);
        File.WriteAllText(Path.Combine(folder.Path, file), new string('\n', program.Pass.Program.Line - 1) + program.Pass.Program.Text);
        foreach (var keywords in program.Variants)
            foreach (var stage in new[] { ("vert", program.VertexFunction), ("frag", program.FragmentFunction) })
                foreach (var error in Compile(program, keywords, stage, folder.Path, file)) yield return error;
    }

    static IEnumerable<string> Compile(PassProgram program, string[] keywords, (string Name, string Function) stage, string folder, string file)
    {
        var multiview = keywords.Contains("STEREO_MULTIVIEW_ON");
        string[] defines =
        [
            .. keywords.Select(k => k + "=1"), multiview ? "SHADER_API_VULKAN=1" : "SHADER_API_D3D11=1", "SHADER_TARGET=45",
            stage.Name == "vert" ? "SHADER_STAGE_VERTEX=1" : "SHADER_STAGE_FRAGMENT=1",
        ];
        string[] arguments =
        [
            "-D", "-V", "-S", stage.Name, "-e", stage.Function, "-o", "program.spv", .. defines.Select(d => "-D" + d),
            .. program.Folders.Select(f => "-I" + f), file,
        ];
        var start = new ProcessStartInfo(Tool, arguments) { WorkingDirectory = folder, RedirectStandardOutput = true, RedirectStandardError = true };
        using var process = Process.Start(start);
        var error = process.StandardError.ReadToEndAsync();
        var output = process.StandardOutput.ReadToEnd() + error.Result;
        process.WaitForExit();
        if (process.ExitCode == 0 && !output.Contains("Missing functionality", StringComparison.Ordinal)) return [];
        var variant = keywords.Length == 0 ? "no keywords" : string.Join(" ", keywords);
        var lines = output.Split('\n', StringSplitOptions.RemoveEmptyEntries)
            .Where(line => line != file && !line.StartsWith("SPIR-V", StringComparison.Ordinal))
            .Where(line => !line.Contains("compilation errors", StringComparison.Ordinal));
        return lines.Select(line => $"{program}, {variant}, {stage.Name}: {line.Replace("ERROR: ", "", StringComparison.Ordinal)}");
    }
}
