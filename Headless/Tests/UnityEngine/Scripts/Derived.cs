namespace Nowpose.Headless.Tests.Engine;

sealed class Derived : HiddenMessages
{
}
