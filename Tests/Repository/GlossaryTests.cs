using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>Tests that the manual has the glossary. An installed package has no files outside itself, so the manual contains a copy.</summary>
public sealed class GlossaryTests
{
    const string Glossary = "docs/glossary.md";
    const string Copy = RepositoryFiles.Package + "/Documentation~/glossary.md";

    [Test]
    public void Copy_InTheManual_EqualsTheGlossary() =>
        Assert.That(RepositoryFiles.Read(Copy), Is.EqualTo(RepositoryFiles.Read(Glossary)), $"copy the glossary: cp {Glossary} {Copy}");
}
