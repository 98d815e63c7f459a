using System.Reflection;
using System.Runtime.Loader;
using Nowpose.Benchmarks.Ablation;

namespace Nowpose.Benchmarks.Sensitivity;

/// <summary>Runs the ablation's motions with another version of the package's Core. The versions exist side by side in one process.</summary>
sealed class VariantContext(byte[] core, string coreName) : AssemblyLoadContext(isCollectible: true)
{
    /// <summary>Gets the errors of the default predictor, for each group of motions.</summary>
    /// <inheritdoc cref="AblationGroup.All"/>
    public double[][] Errors(string recordings, string motions)
    {
        var assembly = LoadFromAssemblyPath(typeof(VariantContext).Assembly.Location);
        var errors = assembly.GetType(typeof(VariantContext).FullName!)!.GetMethod(nameof(ErrorsHere), BindingFlags.Static | BindingFlags.NonPublic)!;
        return (double[][])errors.Invoke(null, [recordings, motions]);
    }

    /// <summary>Gets the errors with the Core of the assembly's own context.</summary>
    static double[][] ErrorsHere(string recordings, string motions) => AblationGroup.Errors(AblationGroup.All(recordings, motions));

    protected override Assembly Load(AssemblyName assemblyName)
    {
        var name = assemblyName.Name!;
        if (name == coreName) return LoadFromStream(new MemoryStream(core));
        // All assemblies of Nowpose use the Core, so each context has its own.
        var path = Path.Combine(AppContext.BaseDirectory, name + ".dll");
        return name.StartsWith("Nowpose", StringComparison.Ordinal) && File.Exists(path) ? LoadFromAssemblyPath(path) : null;
    }
}
