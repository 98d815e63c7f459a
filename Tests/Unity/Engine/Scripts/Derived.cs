namespace Nowpose.Unity.Tests.Engine;

sealed class Derived : HiddenMessages
{
}
