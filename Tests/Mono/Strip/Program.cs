using System.Runtime.InteropServices;
using Mono.Cecil;

// Debian's class library for Mono declares the return value of ReadOnlySpan<T>'s indexer without the modifier that Roslyn writes into each
// call, so Mono does not find the method. This program removes the modifier from the calls in all assemblies of a folder.
if (args.Length != 1 || !Directory.Exists(args[0]))
{
    Console.Error.WriteLine("usage: Nowpose.Mono.Strip FOLDER (with the assemblies to change)");
    return 2;
}

using var resolver = new DefaultAssemblyResolver();
resolver.AddSearchDirectory(args[0]);
resolver.AddSearchDirectory(RuntimeEnvironment.GetRuntimeDirectory());

foreach (var path in Directory.GetFiles(args[0], "*.dll"))
{
    using var assembly = AssemblyDefinition.ReadAssembly(path, new ReaderParameters { InMemory = true, AssemblyResolver = resolver });
    var calls = assembly.Modules.SelectMany(m => m.Types).SelectMany(WithNested).SelectMany(t => t.Methods).Where(m => m.HasBody)
        .SelectMany(m => m.Body.Instructions).Select(i => i.Operand).OfType<MethodReference>()
        .Where(m => m.Name == "get_Item" && m.DeclaringType.GetElementType().FullName == "System.ReadOnlySpan`1" && m.ReturnType.IsRequiredModifier)
        .ToList();
    if (calls.Count == 0) continue;
    // Calls may share one reference; its modifier may have been removed already.
    foreach (var call in calls)
        if (call.ReturnType is RequiredModifierType modified) call.ReturnType = modified.ElementType;
    assembly.Write(path);
}

return 0;

static IEnumerable<TypeDefinition> WithNested(TypeDefinition type) => type.NestedTypes.SelectMany(WithNested).Prepend(type);
