using System.Collections.Concurrent;
using System.Reflection;

namespace Nowpose.UnityPlayer.Assets.Files;

/// <summary>
/// Finds the class of a script file. The class has the name of the file. Its assembly has the name of the nearest assembly definition in the folders
/// above the file. If there is none, any assembly may contain the class.
/// </summary>
sealed class ScriptTypes(AssetIndex index)
{
    readonly ILookup<string, AssetFile> _scripts =
        index.Files.Where(f => f.Extension == ".cs").ToLookup(f => f.Name, StringComparer.Ordinal);

    readonly Dictionary<string, string> _assemblyOfFolder =
        index.Files.Where(f => f.Extension == ".asmdef").ToDictionary(f => FolderOf(f.Path), f => f.Name);

    readonly ConcurrentDictionary<string, Type> _types = new ConcurrentDictionary<string, Type>();

    /// <summary>Returns the class of a script file.</summary>
    /// <exception cref="AssetException">The assembly or the class does not exist, or Unity would not find the class.</exception>
    public Type Of(AssetFile script, Type baseType, Place place)
    {
        var type = _types.GetOrAdd(script.Guid, _ => Find(script, place));
        return baseType.IsAssignableFrom(type) ? type : throw place.Error(AssetFault.Script, script.Path + " contains no " + baseType.Name);
    }

    /// <summary>Returns the script file of a class.</summary>
    /// <exception cref="AssetException">No script file, or more than one, has the name of the class.</exception>
    public AssetFile FileOf(Type type, Place place)
    {
        var assembly = type.Assembly.GetName().Name;
        var found = _scripts[type.Name].Where(f => (AssemblyOf(f) ?? assembly) == assembly).ToList();
        return found.Count == 1
            ? found[0]
            : throw place.Error(AssetFault.Script, "the class " + type.FullName + " is in " + found.Count
                + " script files with its name; Unity needs exactly one");
    }

    Type Find(AssetFile script, Place place)
    {
        var assemblies = AssemblyOf(script) is { } name ? new[] { Load(name, script, place) } : AppDomain.CurrentDomain.GetAssemblies();
        var found = assemblies.SelectMany(TypesOf)
            .Where(t => t.Name == script.Name && !t.IsAbstract && typeof(Object).IsAssignableFrom(t)).ToList();
        return found.Count == 1
            ? found[0]
            : throw place.Error(AssetFault.Script, script.Path + " must contain one class " + script.Name + ", not " + found.Count);
    }

    /// <summary>Returns the name of the assembly of a script file; null if the folders above have no assembly definition.</summary>
    string AssemblyOf(AssetFile script)
    {
        for (var folder = FolderOf(script.Path); folder.Length > 0; folder = FolderOf(folder))
        {
            if (_assemblyOfFolder.TryGetValue(folder, out var name)) return name;
        }
        return null;
    }

    static Assembly Load(string name, AssetFile script, Place place)
    {
        try
        {
            return Assembly.Load(name);
        }
        catch (FileNotFoundException exception)
        {
            throw new AssetException(AssetFault.Script, place + ": the assembly of " + script.Path + ", " + name + ", cannot be loaded", exception);
        }
    }

    static Type[] TypesOf(Assembly assembly)
    {
        try
        {
            return assembly.GetTypes();
        }
        catch (ReflectionTypeLoadException exception)
        {
            return exception.Types.Where(t => t != null).ToArray();
        }
    }

    static string FolderOf(string path)
    {
        var slash = path.LastIndexOf('/');
        return slash < 0 ? "" : path.Substring(0, slash);
    }
}
