using NUnit.Framework;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Security;

namespace Nowpose.Headless.Tests.Gateway;

public class TokenListTests
{
    string _path;

    [SetUp]
    public void SetUp() => _path = Path.GetTempFileName();

    [TearDown]
    public void TearDown() => File.Delete(_path);

    TokenList Read(string text)
    {
        File.WriteAllText(_path, text);
        return TokenList.Read(_path);
    }

    [Test]
    public void Read_TextWithCommentsAndBlankLines_ReturnsTheRoles()
    {
        var tokens = Read("# the cell\n\nobserver abc\n  source\tdef  \noperator ghi\n");

        Assert.That(tokens.RoleOf(TokenList.HashOf("abc")), Is.EqualTo(Role.Observer));
        Assert.That(tokens.RoleOf(TokenList.HashOf("def")), Is.EqualTo(Role.Source));
        Assert.That(tokens.RoleOf(TokenList.HashOf("ghi")), Is.EqualTo(Role.Operator));
        Assert.That(tokens.RoleOf(TokenList.HashOf("abcd")), Is.Null);
        Assert.That(tokens.RoleOf(TokenList.HashOf("")), Is.Null);
    }

    [TestCase("observer a\nadmin secret\n")]
    [TestCase("observer a\nsource\n")]
    [TestCase("observer a\nsource secret more\n")]
    public void Read_InvalidLine_ThrowsWithFileAndLineNumberButNoToken(string text)
    {
        var error = Assert.Throws<InputException>(() => Read(text));

        Assert.That(error.Message, Does.Contain(_path + ", line 2").And.Not.Contain("secret"));
    }

    [Test]
    public void Read_TokenWithTwoRoles_ThrowsWithBothLines()
    {
        var error = Assert.Throws<InputException>(() => Read("observer secret\nsource other\n\nsource secret\n"));

        Assert.That(error.Message, Is.EqualTo(TokenFileMessages.TwoRoles(_path, 1, 4)));
    }

    [Test]
    public void Read_TokenTwiceWithOneRole_ReturnsTheRole() =>
        Assert.That(Read("source a\nsource a\n").RoleOf(TokenList.HashOf("a")), Is.EqualTo(Role.Source));

    [Test]
    public void Read_TextWithoutToken_Throws() => Assert.Throws<InputException>(() => Read("# none\n"));

    [Test]
    public void Read_TokenTooLong_Throws() => Assert.Throws<InputException>(() => Read("source " + new string('x', 513)));

    [Test]
    public void Read_FileMissing_Throws() => Assert.Throws<InputException>(() => TokenList.Read(_path + ".none"));
}
