using System.Reflection;

namespace UnityEditor;

/// <summary>
/// Finds the types of all assemblies that use the editor's API. Loads these assemblies explicitly: the editor loads all assemblies of a
/// project, but .NET loads an assembly only at its first use.
/// </summary>
static class EditorAssemblies
{
    static readonly Lazy<Type[]> All = new Lazy<Type[]>(() => Load().SelectMany(a => a.GetTypes()).ToArray());

    internal static IEnumerable<Type> Types => All.Value;

    static IEnumerable<Assembly> Load()
    {
        var own = typeof(EditorAssemblies).Assembly.GetName().Name;
        foreach (var file in Directory.GetFiles(AppContext.BaseDirectory, "Nowpose*.dll"))
        {
            var assembly = Assembly.Load(AssemblyName.GetAssemblyName(file));
            if (assembly.GetReferencedAssemblies().Any(r => r.Name == own)) yield return assembly;
        }
    }
}
