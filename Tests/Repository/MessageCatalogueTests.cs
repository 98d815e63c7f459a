using System.Net;
using System.Reflection;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>Each text of the message catalogues is complete: it has no gaps and contains all its values.</summary>
public sealed partial class MessageCatalogueTests
{
    static readonly string[] Assemblies = ["Nowpose", "Nowpose.Unity", "Nowpose.Editor", "Nowpose.Gateway", "Nowpose.Cli"];

    /// <summary>Values for the parameters of messages, by type. A name in angle brackets is the parameter's own.</summary>
    static readonly Dictionary<Type, Func<string, object>> Samples = new()
    {
        [typeof(string)] = name => $"<{name}>",
        [typeof(int)] = _ => 7,
        [typeof(uint)] = _ => 7u,
        [typeof(long)] = _ => 7L,
        [typeof(long?)] = _ => 7L,
        [typeof(int?)] = _ => 7,
        [typeof(ulong)] = _ => 7ul,
        [typeof(double)] = _ => 7.0,
        [typeof(double?)] = _ => 7.0,
        [typeof(char)] = _ => '7',
        [typeof(bool)] = _ => true,
        [typeof(IPAddress)] = _ => IPAddress.Parse("7.7.7.7"),
        [typeof(Uri)] = _ => new Uri("http://host7/"),
        [typeof(Version)] = _ => new Version(7, 7),
        [typeof(TimeSpan)] = _ => TimeSpan.FromSeconds(7),
        [typeof(DateTime)] = _ => new DateTime(2027, 7, 7),
        [typeof(Exception)] = _ => new IOException("<7>"),
        [typeof(IReadOnlyList<string>)] = name => new[] { $"<{name}>", "<7>" },
        [typeof(IReadOnlyCollection<string>)] = name => new[] { $"<{name}>", "<7>" },
    };

    static IEnumerable<Type> Catalogues => Assemblies.Select(Assembly.Load).SelectMany(assembly => assembly.GetTypes())
        .Where(type => type.Namespace?.EndsWith(".Messages", StringComparison.Ordinal) == true && type is { IsAbstract: true, IsSealed: true, IsNested: false });

    [Test]
    public void Texts_WithSampleValues_AreComplete()
    {
        var texts = Catalogues.SelectMany(TextsOf).ToList();
        Assert.That(texts, Has.Count.GreaterThan(1000), "the catalogues are found");

        Assert.That(texts.Where(text => Gap().IsMatch(text.Text)).Select(text => $"{text.Name}: {text.Text}"), Is.Empty);
    }

    [Test]
    public void Methods_WithSampleValues_StateEachNamedValue()
    {
        var missing = from method in Catalogues.SelectMany(MethodsOf)
                      let text = Call(method)
                      from parameter in method.GetParameters()
                      where parameter.ParameterType == typeof(string) && !text.Contains($"<{parameter.Name}>", StringComparison.Ordinal)
                      select $"{method.DeclaringType.Name}.{method.Name}: {parameter.Name}";

        Assert.That(missing, Is.Empty);
    }

    static IEnumerable<(string Name, string Text)> TextsOf(Type catalogue) =>
        catalogue.GetFields(BindingFlags.Public | BindingFlags.Static).Where(field => field.FieldType == typeof(string))
            .Select(field => ($"{catalogue.Name}.{field.Name}", (string)field.GetValue(null)))
            .Concat(MethodsOf(catalogue).Select(method => ($"{catalogue.Name}.{method.Name}", Call(method))));

    static IEnumerable<MethodInfo> MethodsOf(Type catalogue) => catalogue.GetMethods(BindingFlags.Public | BindingFlags.Static)
        .Where(method => method.ReturnType == typeof(string) && method.GetParameters().All(parameter => IsSampled(parameter.ParameterType)));

    static bool IsSampled(Type type) => Samples.ContainsKey(type) || type.IsEnum;

    static string Call(MethodInfo method) => (string)method.Invoke(null, [.. method.GetParameters().Select(parameter =>
        parameter.ParameterType.IsEnum ? Enum.GetValues(parameter.ParameterType).GetValue(0) : Samples[parameter.ParameterType](parameter.Name))]);

    // Two blanks within a line, a blank before a punctuation mark, a brace of a format, or an empty text.
    [GeneratedRegex(@"\S  +\S| [,;:.](?!\w)|[{}]|^\s*$|;\s*;")]
    private static partial Regex Gap();
}
